#include "cli/session.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/mem.h"
#include "base/units.h"
#include "check/model.h"
#include "cli/command_line.h"
#include "cli/input_files.h"
#include "cli/run.h"
#include "fivecheck.h"
#include "report/format/json.h"
#include "report/output.h"
#include "report/pose_json.h"
#include "scene/pose_clearance.h"

static const struct srcloc nowhere;

struct session {
	struct model *model;	/* prepared; NULL: none is loaded */
	char *machine, *setup;	/* the files from which it was loaded; setup may be NULL */
	struct known_digests digests;	/* of these files, and of the meshes */
	double clearance;
	int dialect;	/* the machine file's own */
	struct sweep sweep;
};

struct session *session_new(void)
{
	json_init();
	return mem_zalloc(1, sizeof(struct session));
}

static void forget(struct session *session)
{
	model_free(session->model);
	free(session->machine);
	free(session->setup);
	known_digests_release(&session->digests);
	session->model = NULL;
	session->machine = session->setup = NULL;
}

void session_free(struct session *session)
{
	if (!session)
		return;
	forget(session);
	sweep_release(&session->sweep);
	free(session);
}

static bool same_text(const char *a, const char *b)
{
	return a && b ? !strcmp(a, b) : a == b;
}

/* Loads the machine of the options, unless it is loaded already. The options then refer to the session's copies. */
static bool load_model(struct session *session, struct options *options, struct diag *diag)
{
	bool fits = session->model && same_text(session->machine, options->machine) &&
		    same_text(session->setup, options->setup) &&
		    !(session->clearance < options->clearance || session->clearance > options->clearance);

	if (!fits) {
		forget(session);
		session->machine = mem_strndup(options->machine, strlen(options->machine));
		session->setup = options->setup ? mem_strndup(options->setup, strlen(options->setup)) : NULL;
		session->clearance = options->clearance;
		session->model = model_load(session->machine, session->setup, options->check.read.input_root, diag);
		if (session->model) {
			session->dialect = session->model->machine->controller.dialect;
			if (!fivecheck_prepare(session->model, session->clearance, diag))
				forget(session);
		}
	}
	if (!session->model)
		return false;
	options->machine = session->machine;
	options->setup = session->setup;
	session->model->machine->controller.dialect = session->dialect;
	return true;
}

enum run_status session_check(struct session *session, int argc, char **argv)
{
	enum run_status status = RUN_INCOMPLETE;
	struct options options;
	struct stderr_ui ui;

	stderr_ui_init(&ui);
	if (!command_line_parse(&options, argc, argv, &ui.diag)) {
		/* Reported. */
	} else if (options.mode != RUN_CHECK || options.jobs) {
		diag_error(&ui.diag, nowhere, "a loaded machine can only check programs");
	} else if (load_model(session, &options, &ui.diag)) {
		status = run_options_on(&options, session->model, &session->digests, &ui);
	}
	options_release(&options);
	return status;
}

/* Reads "X=12.5" or "T=3". */
static bool read_word(const struct machine *machine, const char *word, axis_values *q, int *tool)
{
	char *end = NULL;
	double value = word[0] && word[1] == '=' ? strtod(word + 2, &end) : NAN;
	int slot = slot_of_letter(word[0]);

	if (!end || end == word + 2 || *end || !isfinite(value))
		return false;
	if (word[0] == 'T') {
		*tool = value >= 0 && value <= 1e9 ? (int)value : 0;
		return true;
	}
	if (slot < 0 || !machine_axis(machine, slot))
		return false;
	q->v[slot] = slot_is_rotary(slot) ? radians(value) : value;
	return true;
}

/* Prints the line. */
static enum run_status tell_pose(struct session *session, const axis_values *q, int tool, struct diag *diag)
{
	struct scene *scene = session->model->scene;
	enum pose_state *states = mem_zalloc(scene->pair_count + 1, sizeof(*states));
	struct pose_clearance clearance;
	struct strbuf text = {0};
	bool told;

	pose_clearance_find(scene, &session->sweep, q, tool, FIVECHECK_TOLERANCE, &clearance, states, diag);
	pose_json_add(&text, scene, q, tool, &clearance, states);
	told = output_print(&text, diag);
	strbuf_release(&text);
	free(states);
	if (!told || clearance.counts[POSE_FAILED] || clearance.counts[POSE_UNKNOWN])
		return RUN_INCOMPLETE;
	return clearance.counts[POSE_OVERLAP] || clearance.counts[POSE_NEAR] ? RUN_FOUND : RUN_CLEAR;
}

enum run_status session_pose(struct session *session, int argc, char **argv)
{
	struct stderr_ui ui;
	axis_values q;
	int tool = 0;

	stderr_ui_init(&ui);
	if (!session->model) {
		diag_error(&ui.diag, nowhere, "no machine is loaded: check a program first");
		return RUN_INCOMPLETE;
	}
	q = machine_home(session->model->machine);
	for (int i = 1; i < argc; i++) {
		if (!read_word(session->model->machine, argv[i], &q, &tool)) {
			diag_error(&ui.diag, nowhere,
				   "'%s' is not a position of an axis of this machine, such as X=12.5",
				   argv[i]);
			return RUN_INCOMPLETE;
		}
	}
	return tell_pose(session, &q, tool, &ui.diag);
}
