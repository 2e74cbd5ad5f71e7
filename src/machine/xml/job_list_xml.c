#include "machine/job_list.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/ascii.h"
#include "machine/xml/body_xml.h"
#include "machine/xml/xml_attribute.h"
#include "machine/xml/xml_element.h"

static const char *const elements[] = {"jobs", "job", "program", NULL};

/* The text between the start of the file and its root element is short. */
enum { HEAD_BYTES = 4096 };

bool job_list_is(const char *path)
{
	static const char root[] = "<jobs";
	char head[HEAD_BYTES + 1];
	const char *at = head;
	struct stat status;
	/* Opening a FIFO would wait for its writer. */
	FILE *file = stat(path, &status) == 0 && S_ISREG(status.st_mode) ? fopen(path, "re") : NULL;
	size_t count = file ? fread(head, 1, HEAD_BYTES, file) : 0;

	if (file)
		fclose(file);
	head[count] = '\0';
	/* The declaration and comments come before the root element. */
	for (at = strchr(at, '<'); at && (at[1] == '?' || at[1] == '!'); at = at ? strchr(at, '<') : NULL)
		at = strncmp(at, "<!--", 4) == 0 ? strstr(at, "-->") : strchr(at, '>');
	return at && !strncmp(at, root, sizeof(root) - 1) && at[sizeof(root) - 1] &&
	       strchr(" \t\r\n/>", at[sizeof(root) - 1]);
}

/* The list whose jobs are being read, and the current job. */
struct reading {
	struct job_list *list;
	struct job_item *job;
};

static void read_program(struct xml_reader *xml, const xmlNode *node, void *context)
{
	const struct reading *r = context;
	const char *path;

	xml_require(xml, node, "file", NULL);
	path = body_xml_path(xml, node, "file", &r->list->arena);
	/* Only the command line can name standard input. */
	r->job->programs[r->job->program_count++] = path && !strcmp(path, "-") ? "./-" : path;
	xml_read_nothing(xml, node);
}

/* Job names become parts of file names. */
static bool is_plain(const char *name)
{
	for (const char *at = name; *at; at++)
		if (!ascii_is_alphanumeric(*at) && !strchr("._-", *at))
			return false;
	return *name != '.';
}

static void check_name(struct xml_reader *xml, const xmlNode *node, const struct job_list *list, const char *name)
{
	if (!is_plain(name))
		xml_error(xml, node, "name",
			  "name=\"%s\" of <job> can have only letters, digits, '.', '_' and '-', and must not begin "
			  "with '.'",
			  xml_quote(name).text);
	for (size_t i = 0; i + 1 < list->count; i++)
		if (list->items[i].name && !strcmp(list->items[i].name, name))
			xml_error(xml, node, "name", "two jobs have the name \"%s\" (also in line %ld)", name,
				  list->items[i].line);
}

static void read_job(struct xml_reader *xml, const xmlNode *node, void *context)
{
	static const struct xml_child children[] = {{"program", read_program, false, true}, {.name = NULL}};
	struct job_list *list = context;
	struct job_item *job = &list->items[list->count++];
	struct reading reading = {list, job};

	xml_require(xml, node, "name", "machine", NULL);
	job->line = xml_line(xml, node);
	job->name = xml_name(xml, node, "name", &list->arena);
	if (job->name)
		check_name(xml, node, list, job->name);
	job->machine = body_xml_path(xml, node, "machine", &list->arena);
	job->setup = body_xml_path(xml, node, "setup", &list->arena);
	job->waivers = body_xml_path(xml, node, "waivers", &list->arena);
	job->programs = arena_alloc(&list->arena, xml_count(node, "program") * sizeof(*job->programs));
	xml_read_children(xml, node, children, &reading);
}

bool job_list_load(struct job_list *list, const char *path, struct diag *diag)
{
	static const struct xml_child children[] = {{"job", read_job, false, true}, {.name = NULL}};
	struct job_list read = {.path = path};
	struct xml_reader xml;
	bool good;

	if (!xml_open(&xml, path, elements, diag))
		return false;
	xml_require(&xml, xml_root(&xml), "version", NULL);
	read.items = arena_alloc(&read.arena, xml_count(xml_root(&xml), "job") * sizeof(*read.items));
	xml_read_children(&xml, xml_root(&xml), children, &read);
	good = !xml.errors;
	xml_close(&xml);
	if (good)
		*list = read;
	else
		job_list_release(&read);
	return good;
}

void job_list_release(struct job_list *list)
{
	arena_release(&list->arena);
	*list = (struct job_list){0};
}
