#include "verdict.h"

#include <fcntl.h>
#include <fstream>
#include <jansson.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

/* Seconds. */
static const char PATIENCE[] = "120";

static void redirect(const std::string &path, int to)
{
	int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);

	if (file < 0 || dup2(file, to) < 0)
		_exit(126);
	close(file);
}

static int run(const std::string &folder, const std::vector<std::string> &words)
{
	std::vector<char *> argv;
	int status;
	pid_t child;

	for (const std::string &word : words)
		argv.push_back(const_cast<char *>(word.c_str()));
	argv.push_back(nullptr);
	child = fork();
	if (child < 0)
		throw std::runtime_error("no process could be started");
	if (!child) {
		if (chdir(folder.c_str()))
			_exit(126);
		redirect("out", STDOUT_FILENO);
		redirect("err", STDERR_FILENO);
		execvp(argv[0], argv.data());
		_exit(127);
	}
	if (waitpid(child, &status, 0) != child)
		throw std::runtime_error("a process was lost");
	return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

static std::string text_at(const json_t *row, const char *key)
{
	const char *text = json_string_value(json_object_get(row, key));

	return text ? text : "";
}

static Finding finding_of(const json_t *row, const Machine &machine, const std::string &text)
{
	Finding finding = {text_at(row, "kind"), text_at(row, "a"), text_at(row, "b"), text_at(row, "axis"), text,
			   (int)json_integer_value(json_object_get(row, "line")),
			   json_number_value(json_object_get(row, "fraction")), {}};

	for (int i = 0; i < machine.world.axis_count; i++) {
		const char letter[] = {machine.world.axes[i].letter, 0};

		finding.at[(size_t)i] = json_number_value(json_object_get(json_object_get(row, "axes"), letter));
	}
	return finding;
}

static bool is_finding(const std::string &kind)
{
	return kind == "collision" || kind == "clearance" || kind == "limit" || kind == "start-overlap" ||
	       kind == "rapid-contact";
}

static void read_rows(const std::string &path, const Machine &machine, Verdict &verdict)
{
	std::ifstream in(path);
	std::string text;

	while (std::getline(in, text)) {
		json_t *row = json_loads(text.c_str(), 0, nullptr);

		if (!row)
			throw std::runtime_error("not JSON: " + text);
		if (is_finding(text_at(row, "kind"))) {
			verdict.findings.push_back(finding_of(row, machine, text));
			verdict.rows += text + "\n";
		}
		json_decref(row);
	}
}

Verdict ask_fivecheck(const std::string &fivecheck, const std::string &folder, const Machine &machine,
		      const std::vector<std::string> &options)
{
	std::vector<std::string> words = {"timeout", PATIENCE, fivecheck, "-f", "ndjson"};
	std::ostringstream errors;
	Verdict verdict;

	if (machine.has_setup)
		words.insert(words.end(), {"-s", "s.xml"});
	words.insert(words.end(), options.begin(), options.end());
	words.insert(words.end(), {"m.xml", "p.nc"});
	verdict.status = run(folder, words);
	read_rows(folder + "/out", machine, verdict);
	errors << std::ifstream(folder + "/err").rdbuf();
	verdict.errors = errors.str();
	return verdict;
}
