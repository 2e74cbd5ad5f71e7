/*
 * fivecheck-cgi.c - checks an upload on the server: the body of a POST is a tar archive with the files of a job, the
 * query names them.
 *
 *     tar --format=ustar -cf - machine.xml stl part.nc | curl --data-binary @- \
 *         -H 'Content-Type: application/x-tar' 'http://127.0.0.1/fivecheck/check?machine=machine.xml&program=part.nc'
 *
 * Query: machine, program (up to 8 of them), setup, clearance, dialect, all=1, format=text or ndjson. The answer is what
 * fivecheck prints, messages included; the header Fivecheck-Status is its exit status.
 *
 * Nothing of an upload is trusted. It is a plain archive, so its files cannot be larger unpacked than they were sent;
 * their number, folders included, is bounded. Links are never unpacked, and no name leads out of the folder of the job.
 * fivecheck runs with limits of time, memory, output and processes, sees this folder alone (--input-root), and is never
 * more than once a processor at work. The folder is removed in the end. At most UPLOADS_MAX uploads lie unpacked at a
 * time; others wait before they are read.
 *
 * Environment (SetEnv): FIVECHECK, the program; FIVECHECK_WORK, a folder that only this program can write to;
 * FIVECHECK_MB, the largest upload; FIVECHECK_SECONDS, processor time of a job.
 */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define DEFAULT_PROGRAM "/usr/bin/fivecheck"
#define DEFAULT_WORK "/var/lib/fivecheck"

enum {
	DEFAULT_MB = 64,
	DEFAULT_SECONDS = 60,	/* of the processor */
	WAIT_SECONDS = 60,	/* for the upload; for a free processor */
	FILES_MAX = 1000,	/* and folders */
	UPLOADS_MAX = 32,	/* that lie unpacked at a time */
	NUMBER_LENGTH = 20,
	PROGRAMS_MAX = 8,
	PATH_LENGTH = 200,
	OUTPUT_MB = 32,
	MEMORY_MB = 2048,
	SLOTS_MAX = 64,
	RECORD = 512	/* of a tar archive */
};

static char folder[512];	/* of the job; empty: none was made */
/* So much more than is allowed is read, to be thrown away. */
#define DISCARDED_MAX (64L << 20)

static long unread;	/* bytes of the body */
static volatile sig_atomic_t child, ended;

static int remove_one(const char *path, const struct stat *status, int flag, struct FTW *where)
{
	(void)status;
	(void)flag;
	(void)where;
	return remove(path);
}

static void clean_up(void)
{
	if (*folder && chdir("/") == 0)
		nftw(folder, remove_one, 16, FTW_DEPTH | FTW_PHYS);
	*folder = '\0';
}

/* A server that cannot hand over all of the body may drop the answer. */
static void refuse(const char *status, const char *format, ...)
{
	va_list arguments;

	clean_up();
	while (!ended && unread > 0 && getchar() != EOF)
		unread--;
	printf("Status: %s\r\nContent-Type: text/plain; charset=utf-8\r\nCache-Control: no-store\r\n", status);
	if (!strncmp(status, "503", 3))
		printf("Retry-After: 10\r\n");
	printf("\r\n");
	va_start(arguments, format);
	vprintf(format, arguments);
	va_end(arguments);
	printf("\n");
	exit(EXIT_SUCCESS);
}

/*
 * Time is up, or the server has lost whoever waited: while the upload is read, or while a job runs. What waits is
 * interrupted, and the job ends in its own way, which leaves nothing behind. The signal comes again a second later, for
 * a wait that began just after it.
 */
static void on_end(int number)
{
	(void)number;
	ended = 1;
	alarm(1);
	if (child > 0)
		kill(-child, SIGKILL);
}

static long number_of(const char *name, long otherwise, long most)
{
	const char *text = getenv(name);
	char *end;
	long value = text ? strtol(text, &end, 10) : 0;

	return text && *text && !*end && value > 0 && value <= most ? value : otherwise;
}

struct query {
	char *machine, *setup, *clearance, *dialect;
	char *programs[PROGRAMS_MAX];
	int program_count;
	bool all, ndjson;
};

static int hex(char digit)
{
	const char *digits = "0123456789abcdef", *at = digit ? strchr(digits, tolower((unsigned char)digit)) : NULL;

	return at ? (int)(at - digits) : -1;
}

/* Decodes %xx and + in place. False: malformed, or a byte that no name has. */
static bool decode(char *text)
{
	char *to = text;

	for (const char *from = text; *from; from++) {
		int value = (unsigned char)*from;

		if (value == '+') {
			value = ' ';
		} else if (value == '%') {
			if (hex(from[1]) < 0 || hex(from[2]) < 0)
				return false;
			value = 16 * hex(from[1]) + hex(from[2]);
			from += 2;
		}
		if (value < 32 || value == 127)
			return false;
		*to++ = (char)value;
	}
	*to = '\0';
	return true;
}

/* Is it a relative path that stays where it is, of parts that begin with no dash? */
static bool is_safe_path(const char *path)
{
	if (!*path || strlen(path) > PATH_LENGTH || strpbrk(path, "\\:"))
		return false;
	for (const char *part = path;;) {
		size_t length = strcspn(part, "/");

		if (length == 0 || *part == '-' || *part == '.')
			return false;
		for (size_t i = 0; i < length; i++) {
			if ((unsigned char)part[i] < 32 || part[i] == 127)
				return false;
		}
		if (!part[length])
			return true;
		part += length + 1;
	}
}

static void take_once(char **word, char *value)
{
	if (*word)
		refuse("400 Bad Request", "the query has a word twice");
	*word = value;
}

static void take_word(struct query *query, const char *name, char *value)
{
	if (!strcmp(name, "machine"))
		take_once(&query->machine, value);
	else if (!strcmp(name, "setup"))
		take_once(&query->setup, value);
	else if (!strcmp(name, "clearance"))
		take_once(&query->clearance, value);
	else if (!strcmp(name, "dialect"))
		take_once(&query->dialect, value);
	else if (!strcmp(name, "all") && !strcmp(value, "1"))
		query->all = true;
	else if (!strcmp(name, "format") && (!strcmp(value, "text") || !strcmp(value, "ndjson")))
		query->ndjson = !strcmp(value, "ndjson");
	else if (!strcmp(name, "program") && query->program_count < PROGRAMS_MAX)
		query->programs[query->program_count++] = value;
	else
		refuse("400 Bad Request", "the query has a word or value that is not known, or too many programs");
}

static bool is_word_of(const char *word, const char *letters)
{
	const size_t length = strlen(word);

	return length <= NUMBER_LENGTH && strspn(word, letters) == length;
}

static void read_query(struct query *query, char *text)
{
	char *next = text;

	while (next && *next) {
		char *word = next, *value;

		next = strchr(word, '&');
		if (next)
			*next++ = '\0';
		value = strchr(word, '=');
		if (!value)
			refuse("400 Bad Request", "the query has a word without a value");
		*value++ = '\0';
		if (!decode(value))
			refuse("400 Bad Request", "the query is malformed");
		take_word(query, word, value);
	}
	if (!query->machine || !query->program_count)
		refuse("400 Bad Request",
		       "the query must name a machine and a program: ?machine=machine.xml&program=part.nc");
	for (int i = 0; i < query->program_count; i++) {
		if (!is_safe_path(query->programs[i]))
			refuse("400 Bad Request", "this is no name of a program");
	}
	if (!is_safe_path(query->machine) || (query->setup && !is_safe_path(query->setup)))
		refuse("400 Bad Request", "this is no name of a file");
	if (query->clearance && !is_word_of(query->clearance, "0123456789."))
		refuse("400 Bad Request", "the clearance is no number, or has more than %d characters", NUMBER_LENGTH);
	if (query->dialect && !is_word_of(query->dialect, "abcdefghijklmnopqrstuvwxyz"))
		refuse("400 Bad Request", "this is no name of a control");
}

/* Octal digits, which a space or 0 ends. -1: malformed. */
static long octal(const char *field, size_t length)
{
	long value = 0;
	size_t i = 0;

	while (i < length && field[i] == ' ')
		i++;
	for (; i < length && field[i] >= '0' && field[i] <= '7'; i++) {
		if (value > 1L << 40)
			return -1;
		value = 8 * value + (field[i] - '0');
	}
	return i < length && field[i] != ' ' && field[i] != '\0' ? -1 : value;
}

static bool has_checksum(const char *head)
{
	long sum = 0;

	for (int i = 0; i < RECORD; i++)
		sum += i >= 148 && i < 156 ? ' ' : (unsigned char)head[i];
	return octal(head + 148, 8) == sum;
}

/* Reads some bytes of the body. False: it has ended, or time is up. */
static bool read_body(char *to, size_t count)
{
	if ((long)count > unread || fread(to, 1, count, stdin) != count)
		return false;
	unread -= (long)count;
	return true;
}

static void count_one(int *files)
{
	if (++*files > FILES_MAX)
		refuse("413 Content Too Large", "the archive has more than %d files and folders", FILES_MAX);
}

/* Each folder counts: the name of one empty file can hold a hundred of them. */
static void make_folder(const char *path, int *files)
{
	if (mkdir(path, 0700) == 0)
		count_one(files);
	else if (errno != EEXIST)
		refuse("400 Bad Request", "a name in the archive is used twice");
}

static void make_folders(char *path, int *files)
{
	for (char *slash = strchr(path, '/'); slash; slash = strchr(slash + 1, '/')) {
		*slash = '\0';
		make_folder(path, files);
		*slash = '/';
	}
}

static void unpack_file(const char *path, long size)
{
	int fd = open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
	char record[RECORD];

	if (fd < 0)
		refuse("400 Bad Request", "a name in the archive is used twice");
	for (; size > 0; size -= RECORD) {
		size_t count = size < RECORD ? (size_t)size : RECORD;

		if (!read_body(record, RECORD))
			refuse("400 Bad Request", "the archive is cut off");
		if (write(fd, record, count) != (ssize_t)count)
			refuse("507 Insufficient Storage", "there is no room for the upload");
	}
	close(fd);
}

/* The name in a header: the prefix of ustar, a slash, the name; without the dot that tar may begin with. */
static void name_of(const char *head, char path[PATH_LENGTH + 101])
{
	char full[300];
	const char *from = full;
	size_t length;

	if (memcmp(head + 257, "ustar", 5) == 0 && head[345])
		snprintf(full, sizeof(full), "%.155s/%.100s", head + 345, head);
	else
		snprintf(full, sizeof(full), "%.100s", head);
	if (from[0] == '.' && from[1] == '/')
		from += 2;
	length = strlen(from);
	if (length && from[length - 1] == '/')
		length--;
	snprintf(path, PATH_LENGTH + 101, "%.*s", (int)length, from);
}

static void unpack(void)
{
	char head[RECORD], path[PATH_LENGTH + 101];
	int files = 0;

	while (unread > 0 && read_body(head, RECORD) && head[0]) {
		long size = octal(head + 124, 12);
		char kind = head[156];

		if (!has_checksum(head) || size < 0)
			refuse("400 Bad Request", "this is no tar archive; make it with tar --format=ustar");
		if (kind != '0' && kind != '\0' && kind != '5')
			refuse("400 Bad Request",
			       "the archive has a link, a device, or a form of tar that is not read here "
			       "(tar --format=ustar)");
		name_of(head, path);
		if (kind == '5' && (!*path || !strcmp(path, ".")))
			continue;
		if (!is_safe_path(path))
			refuse("400 Bad Request",
			       "the archive has a name that is not allowed: it leads elsewhere, or begins "
			       "with a dot or a dash");
		make_folders(path, &files);
		if (kind == '5') {
			make_folder(path, &files);
		} else {
			count_one(&files);
			unpack_file(path, size);
		}
	}
	/* What follows is of no interest, but the server wants to be rid of it. */
	while (!ended && unread > 0 && getchar() != EOF)
		unread--;
}

/*
 * Takes one of the locks of a name; waits for one if all are taken, and refuses the request when time is up. Closing the
 * descriptor gives the lock back.
 */
static int take_lock(const char *work, const char *name, long count, const char *none)
{
	int last = -1;

	for (long i = 0; i < count; i++) {
		char path[600];

		snprintf(path, sizeof(path), "%s/%s-%ld", work, name, (getpid() + i) % count);
		if (last >= 0)
			close(last);
		last = open(path, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
		if (last < 0)
			refuse("500 Internal Server Error", "the folder of the checker cannot be written to");
		if (flock(last, LOCK_EX | LOCK_NB) == 0)
			return last;
	}
	if (ended || flock(last, LOCK_EX))
		refuse("503 Service Unavailable", "%s; try again", none);
	return last;
}

static int take_processor(const char *work)
{
	long count = sysconf(_SC_NPROCESSORS_ONLN);

	return take_lock(work, "slot", count < 1 ? 1 : count > SLOTS_MAX ? SLOTS_MAX : count, "all processors are at work");
}

static void limit(int what, long most)
{
	const struct rlimit both = {(rlim_t)most, (rlim_t)most};

	if (setrlimit(what, &both))
		_exit(127);
}

static void limit_child(long seconds)
{
	limit(RLIMIT_CPU, seconds);
	limit(RLIMIT_AS, (long)MEMORY_MB << 20);
	limit(RLIMIT_FSIZE, (long)OUTPUT_MB << 20);
	limit(RLIMIT_NOFILE, 256);
	/* No further process or thread: the user of the server has more already. */
	limit(RLIMIT_NPROC, 1);
	limit(RLIMIT_CORE, 0);
}

static void run_child(const struct query *query, long seconds, int output)
{
	char locale[] = "LC_ALL=C", path[] = "PATH=/usr/bin:/bin";
	char *const environment[] = {locale, path, NULL};
	const char *program = getenv("FIVECHECK") ? getenv("FIVECHECK") : DEFAULT_PROGRAM;
	char setup[PATH_LENGTH + 16], clearance[64], dialect[64];
	const char *argv[PROGRAMS_MAX + 16];
	int count = 0, nothing = open("/dev/null", O_RDONLY);

	argv[count++] = "fivecheck";
	argv[count++] = "--input-root=.";
	argv[count++] = "--progress=none";
	argv[count++] = "-j1";
	argv[count++] = query->ndjson ? "--format=ndjson" : "--format=text";
	if (query->all)
		argv[count++] = "--all";
	if (query->setup && snprintf(setup, sizeof(setup), "--setup=%s", query->setup) > 0)
		argv[count++] = setup;
	if (query->clearance && snprintf(clearance, sizeof(clearance), "--clearance=%s", query->clearance) > 0)
		argv[count++] = clearance;
	if (query->dialect && snprintf(dialect, sizeof(dialect), "--dialect=%s", query->dialect) > 0)
		argv[count++] = dialect;
	argv[count++] = "--";
	argv[count++] = query->machine;
	for (int i = 0; i < query->program_count; i++)
		argv[count++] = query->programs[i];
	argv[count] = NULL;
	setpgid(0, 0);
	limit_child(seconds);
	if (nothing < 0 || dup2(nothing, 0) < 0 || dup2(output, 1) < 0 || dup2(output, 2) < 0)
		_exit(127);
	execve(program, (char *const *)argv, environment);
	_exit(127);
}

/* Runs fivecheck; its output is in the file afterwards. Returns its exit status, -1 if it was ended. */
static int run(const struct query *query, long seconds, int output)
{
	int status;
	pid_t pid = fork();

	if (pid < 0)
		refuse("503 Service Unavailable", "no process could be started; try again");
	if (pid == 0)
		run_child(query, seconds, output);
	setpgid(pid, pid);
	child = pid;
	if (ended)
		kill(-pid, SIGKILL);
	/* A job that waits for something it will not get uses no processor time. */
	alarm((unsigned)(2 * seconds));
	while (waitpid(pid, &status, 0) < 0) {
		if (errno != EINTR)
			refuse("500 Internal Server Error", "the checker was lost");
	}
	child = 0;
	alarm(0);
	return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void answer(const struct query *query, int status, int output)
{
	FILE *file = fdopen(output, "rb");
	char bytes[4096];
	size_t count;

	if (status < 0)
		refuse("503 Service Unavailable", "the job took more time or memory than is allowed here");
	if (!file || status == 127 || fseek(file, 0, SEEK_SET))
		refuse("500 Internal Server Error", "fivecheck could not be started");
	printf("Content-Type: %s; charset=utf-8\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n"
	       "Fivecheck-Status: %d\r\n\r\n",
	       query->ndjson ? "application/x-ndjson" : "text/plain", status);
	while ((count = fread(bytes, 1, sizeof(bytes), file)) > 0)
		fwrite(bytes, 1, count, stdout);
	fclose(file);
}

/* The type of an upload, in any case, with or without parameters. */
static bool is_tar(const char *type)
{
	static const char tar[] = "application/x-tar";
	const size_t length = sizeof(tar) - 1;

	return !strncasecmp(type, tar, length) && (type[length] == '\0' || strchr("; ", type[length]));
}

int main(void)
{
	const char *method = getenv("REQUEST_METHOD"), *length = getenv("CONTENT_LENGTH"),
		   *type = getenv("CONTENT_TYPE");
	const char *work = getenv("FIVECHECK_WORK") ? getenv("FIVECHECK_WORK") : DEFAULT_WORK,
		   *text = getenv("QUERY_STRING");
	const struct sigaction end = {.sa_handler = on_end};
	long most = number_of("FIVECHECK_MB", DEFAULT_MB, 4096) << 20, size = number_of("CONTENT_LENGTH", 0, 1L << 40);
	long seconds = number_of("FIVECHECK_SECONDS", DEFAULT_SECONDS, 86400);
	char words[4096];
	struct query query = {0};
	int room, slot, output, status;

	sigaction(SIGALRM, &end, NULL);
	sigaction(SIGTERM, &end, NULL);
	sigaction(SIGHUP, &end, NULL);
	umask(077);
	/* Also what is too large is taken, up to a bound: an answer to who is still sending may be lost. */
	unread = size - most <= DISCARDED_MAX ? size : most + DISCARDED_MAX;
	alarm(WAIT_SECONDS);
	if (!method || strcmp(method, "POST") != 0)
		refuse("405 Method Not Allowed", "send the files of a job as a tar archive with POST");
	if (!length || !size)
		refuse("411 Length Required", "the length of the upload must be known");
	if (size > most)
		refuse("413 Content Too Large", "an upload may have %ld MB", most >> 20);
	if (!type || !is_tar(type) || getenv("HTTP_CONTENT_ENCODING"))
		refuse("415 Unsupported Media Type", "the upload must be a plain tar archive, application/x-tar");
	if (!text || strlen(text) >= sizeof(words))
		refuse("400 Bad Request", "the query is missing or too long");
	strcpy(words, text);
	read_query(&query, words);
	room = take_lock(work, "room", UPLOADS_MAX, "there are too many uploads");
	snprintf(folder, sizeof(folder), "%.400s/job-XXXXXX", work);
	if (!mkdtemp(folder)) {
		*folder = '\0';
		refuse("500 Internal Server Error", "the folder of the checker cannot be written to");
	}
	if (chdir(folder))
		refuse("500 Internal Server Error", "the folder of the job was lost");
	unpack();
	alarm(WAIT_SECONDS);
	slot = take_processor(work);
	alarm(0);
	output = open(".output", O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_APPEND, 0600);
	if (output < 0)
		refuse("500 Internal Server Error", "the folder of the job was lost");
	status = run(&query, seconds, output);
	/* Who reads the answer slowly, or not at all, keeps no processor and no room. */
	close(slot);
	clean_up();
	close(room);
	answer(&query, status, output);
	return EXIT_SUCCESS;
}
