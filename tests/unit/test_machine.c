/* test_machine.c - valid machine files: the values that are read from them. */
#include <math.h>
#include <sys/stat.h>

#include "base/units.h"
#include "control/dialects.h"
#include "machine/setup.h"
#include "machine_case.h"

static void assert_vec3(vec3 v, double x, double y, double z)
{
	ck_assert_double_eq_tol(v.x, x, 1e-12);
	ck_assert_double_eq_tol(v.y, y, 1e-12);
	ck_assert_double_eq_tol(v.z, z, 1e-12);
}

START_TEST(reads_axes)
{
	struct machine *m;
	const struct axis *a;

	write_text("m.xml", trunnion);
	m = load_good("m.xml");
	ck_assert_str_eq(m->name, "trunnion & co");
	ck_assert_str_eq(m->path, "m.xml");
	ck_assert_uint_eq(m->axis_count, 4);
	for (size_t i = 0; i < 4; i++)
		ck_assert_int_eq(m->axes[i].name[0], "YXAC"[i]);
	ck_assert_int_eq(m->axes[0].parent, 0);
	ck_assert_int_eq(m->axes[1].parent, 1);
	ck_assert_int_eq(m->axes[2].parent, 0);
	ck_assert_int_eq(m->axes[3].parent, 3);
	assert_vec3(m->axes[0].direction, 0, 1, 0);
	assert_vec3(m->axes[1].direction, 0, 0.6, 0.8);
	ck_assert_double_eq(m->axes[0].home, 10);
	ck_assert_double_eq(m->axes[0].limit_min, -250);
	ck_assert_double_eq(m->axes[0].rate_max, 500);
	ck_assert(isinf(m->axes[1].limit_max) && m->axes[1].limit_min < 0);
	a = machine_axis(m, SLOT_A);
	ck_assert_str_eq(a->title, "First axis");
	ck_assert_ptr_null(m->axes[0].title);
	ck_assert(a->rotary && a->wrap == WRAP_SIGN && a->half_turn == -1);
	assert_vec3(a->location, 0, 0, 120);
	ck_assert_double_eq_tol(a->limit_min, -120 * PI / 180, 1e-15);
	ck_assert_double_eq_tol(a->rate_max, 120 * PI / 180, 1e-15);
	ck_assert_ptr_null(machine_axis(m, SLOT_B));
	ck_assert_str_eq(machine_link_name(m, 0), "base");
	ck_assert_str_eq(machine_link_name(m, 4), "C");
	ck_assert_double_eq(machine_home(m).v[SLOT_Y], 10);
	ck_assert_double_eq(machine_home(m).v[SLOT_A], 0);
	machine_free(m);
}
END_TEST

START_TEST(reads_bodies_and_mounts)
{
	struct machine *m;
	vec3 p;

	write_text("m.xml", trunnion);
	m = load_good("m.xml");
	ck_assert_uint_eq(m->body_count, 4);
	ck_assert_str_eq(m->bodies[0].name, "bed");
	ck_assert_str_eq(m->bodies[0].mesh_path, "ac/bed.stl");
	ck_assert_int_eq(m->bodies[0].loc.line, 14);
	ck_assert_str_eq(m->bodies[0].loc.file, "m.xml");
	ck_assert_double_eq(m->bodies[0].scale, 1);
	ck_assert_str_eq(m->bodies[1].mesh_path, "/abs/head.stl");
	ck_assert_int_eq(m->bodies[1].link, 2);
	ck_assert_double_eq(m->bodies[1].scale, 25.4);
	ck_assert_double_eq(m->bodies[3].scale, 1000);
	ck_assert_ptr_null(m->bodies[1].solid);
	/* X by 90 turns y to z, then Z by 90 turns x to y: so y -> z, z -> -y -> x, x -> y. */
	p = xform_apply(&m->bodies[1].placement, (vec3){10, 20, 30});
	assert_vec3(p, 1 + 30, 2 + 10, 3 + 20);
	ck_assert(m->spindle.present && m->spindle.link == 2);
	assert_vec3(m->spindle.location, 0, 0, 520);
	assert_vec3(m->spindle.direction, 0, 0, -1);
	ck_assert(m->workholding.present && m->workholding.link == 4);
	assert_vec3(xform_apply(&m->workholding.frame, (vec3){1, 0, 0}), 0, 1, 120);
	machine_free(m);
}
END_TEST

static void check_places(const struct controller *controller)
{
	const struct control_place *change = &controller->tool_change, *first = &controller->references[0],
				   *third = &controller->references[2];

	ck_assert_double_eq(controller->least_input, 0.001);
	ck_assert_int_eq(controller->length_moves, ANSWER_YES);
	ck_assert_int_eq(controller->g53_with_g91, G53_WITH_G91_INCREMENTAL);
	ck_assert_int_eq(controller->length_after_reference, LENGTH_AFTER_REFERENCE_GONE);
	ck_assert_int_eq(controller->power_on_units, POWER_ON_INCH);
	ck_assert_int_eq(controller->power_on_distance, POWER_ON_INCREMENTAL);
	ck_assert_int_eq(controller->power_on_plane, POWER_ON_YZ);
	ck_assert_int_eq(controller->m6_with_move, M6_BEFORE_MOVE);
	ck_assert_int_eq(controller->m6_with_t, M6_LOADS_T_BEFORE);
	ck_assert_int_eq(controller->length_under_g68, LENGTH_UNDER_G68_STRAIGHT);
	ck_assert_int_eq(controller->polar_axis, SLOT_B);
	ck_assert_int_eq(controller->semicolon, SEMICOLON_STARTS_COMMENT);
	ck_assert_int_eq(controller->colon, COLON_BLOCK);
	ck_assert_int_eq(controller->power_on_motion, POWER_ON_FEED);
	ck_assert_int_eq(controller->cycle_repeats, CYCLE_REPEATS_L);
	ck_assert_double_eq(controller->arc_radius_tolerance, 0.5);
	ck_assert(change->given && change->has[SLOT_X] && change->has[SLOT_Y] && change->has[SLOT_C]);
	ck_assert(!change->has[SLOT_Z] && !change->has[SLOT_A]);
	ck_assert_double_eq(change->value.v[SLOT_Y], -10);
	ck_assert_double_eq(change->value.v[SLOT_C], radians(90));
	ck_assert_uint_eq(change->order_count, 3);
	ck_assert(change->order[0] == SLOT_Y && change->order[1] == SLOT_X && change->order[2] == SLOT_C);
	ck_assert(first->given && first->has[SLOT_Y] && !first->has[SLOT_X]);
	ck_assert_double_eq(first->value.v[SLOT_Y], 11);
	ck_assert_uint_eq(first->order_count, 0);
	ck_assert(!controller->references[1].given && !controller->references[3].given);
	ck_assert(third->order_count == 2 && third->order[0] == SLOT_Y && third->order[1] == SLOT_X);
}

/* The schema has its own list of the names of dialects. */
START_TEST(reads_every_dialect)
{
	for (int row = 0; dialect_names[row]; row++) {
		struct machine *m;
		char text[512];

		snprintf(text, sizeof(text),
			 MACHINE("<controller dialect='%s' rapid='linear'/><base><axis name='X' type='linear' "
				 "direction='1 0 0' rate_max='6000'/></base>"),
			 dialect_names[row]);
		write_text("m.xml", text);
		m = load_good("m.xml");
		ck_assert_int_eq(m->controller.dialect, row);
		machine_free(m);
	}
}
END_TEST

START_TEST(reads_controller_and_pairs)
{
	struct machine *m;

	write_text("m.xml", trunnion);
	m = load_good("m.xml");
	ck_assert_str_eq(dialect_names[m->controller.dialect], "haas");
	ck_assert_int_eq(m->controller.rapid, RAPID_DOGLEG);
	ck_assert(m->controller.tcp_zero_offset);
	ck_assert_double_eq(m->controller.path_tolerance, 0.02);
	ck_assert_uint_eq(m->controller.mcode_count, 3);
	ck_assert_int_eq(m->controller.mcodes[1].number, 429);
	ck_assert_int_eq(m->controller.mcodes[1].action, MCODE_TCP_OFF);
	check_places(&m->controller);
	ck_assert_double_eq(m->adjacent_within, 7.5);
	ck_assert_uint_eq(m->rule_count, 3);
	ck_assert_int_eq(m->rules[0].a.kind, NAME_BODY);
	ck_assert_str_eq(m->rules[0].a.body, "cradle");
	ck_assert_int_eq(m->rules[0].b.kind, NAME_LINK);
	ck_assert_int_eq(m->rules[0].b.link, 2);
	ck_assert_int_eq(m->rules[0].check, PAIR_ALWAYS);
	ck_assert_double_eq(m->rules[0].clearance, 2);
	ck_assert_int_eq(m->rules[0].line, 4);
	ck_assert_int_eq(m->rules[1].a.kind, NAME_LINK);
	ck_assert_int_eq(m->rules[1].a.link, 0);
	ck_assert_int_eq(m->rules[1].check, PAIR_NEVER);
	ck_assert_str_eq(m->rules[1].reason, "bellows");
	ck_assert(m->rules[1].clearance < 0);
	ck_assert_int_eq(m->rules[2].a.kind, NAME_ROLE);
	ck_assert_int_eq(m->rules[2].a.role, ROLE_HOLDER);
	ck_assert_int_eq(m->rules[2].b.role, ROLE_FIXTURE);
	ck_assert_int_eq(m->rules[2].check, PAIR_DERIVED);
	machine_free(m);
}
END_TEST

START_TEST(defaults)
{
	struct machine *m;

	write_text("m.xml", MACHINE("<base/>"));
	m = load_good("m.xml");
	ck_assert_str_eq(m->name, "");
	ck_assert_uint_eq(m->axis_count + m->body_count + m->rule_count + m->controller.mcode_count, 0);
	ck_assert_str_eq(dialect_names[m->controller.dialect], "linuxcnc");
	ck_assert_int_eq(m->controller.rapid, RAPID_LINEAR);
	ck_assert(!m->controller.tcp_zero_offset && !m->spindle.present && !m->workholding.present);
	ck_assert_double_eq(m->controller.path_tolerance, 0);
	ck_assert_double_eq(m->adjacent_within, 5);
	ck_assert_ptr_null(m->setup);
	machine_free(m);
}
END_TEST

START_TEST(inches)
{
	struct machine *m;

	write_text("m.xml",
		   "<machine version='1' units='inch'><controller path_tolerance='0.01'/><base>"
		   "<body name='b' mesh='b.stl' location='1 0 0'/><body name='c' mesh='c.stl' units='cm'/>" AXIS_X
		   " limit_min='-1' limit_max='2' home='1'>" AXIS_C
		   " limit_max='90' home='45'><spindle location='0 0 10' direction='0 0 -1'/></axis></axis></base>"
		   "<pairs adjacent_within='0.5'><pair a='b' b='c' clearance='0.1'/></pairs>"
		   "<setup><offset number='1' length='3'/></setup></machine>");
	m = load_good("m.xml");
	ck_assert_double_eq_tol(m->axes[0].limit_min, -25.4, 1e-12);
	ck_assert_double_eq_tol(m->axes[0].home, 25.4, 1e-12);
	ck_assert_double_eq_tol(m->axes[0].rate_max, 2540, 1e-9);
	ck_assert_double_eq_tol(m->axes[1].rate_max, PI / 3, 1e-12);
	ck_assert_double_eq_tol(m->axes[1].limit_max, PI / 2, 1e-12);
	assert_vec3(m->axes[1].location, 25.4, 50.8, 3 * 25.4);
	assert_vec3(m->spindle.location, 0, 0, 254);
	assert_vec3(m->bodies[0].placement.translation, 25.4, 0, 0);
	ck_assert_double_eq(m->bodies[0].scale, 25.4);
	ck_assert_double_eq(m->bodies[1].scale, 10);
	ck_assert_double_eq_tol(m->adjacent_within, 12.7, 1e-12);
	ck_assert_double_eq_tol(m->rules[0].clearance, 2.54, 1e-12);
	ck_assert_double_eq_tol(m->controller.path_tolerance, 0.254, 1e-12);
	ck_assert_double_eq_tol(m->setup->lengths[0].length, 76.2, 1e-12);
	machine_free(m);
}
END_TEST

START_TEST(mesh_beside_its_file)
{
	struct machine *m;
	char path[128];

	ck_assert_int_eq(mkdir("sub", 0777), 0);
	write_text("sub/m.xml", BASE("<body name='b' mesh='stl/b.stl'/><body name='c' mesh='/c.stl'/>"));
	m = load_good("sub/m.xml");
	ck_assert_str_eq(m->bodies[0].mesh_path, "sub/stl/b.stl");
	ck_assert_str_eq(m->bodies[1].mesh_path, "/c.stl");
	machine_free(m);
	snprintf(path, sizeof(path), "%s/sub/m.xml", folder);
	m = load_good(path);
	ck_assert_int_eq(strncmp(m->bodies[0].mesh_path, folder, strlen(folder)), 0);
	ck_assert_str_eq(m->bodies[0].mesh_path + strlen(folder), "/sub/stl/b.stl");
	machine_free(m);
}
END_TEST

/* The setup precedes the workholding on which it is mounted. */
START_TEST(setup_inside)
{
	struct machine *m;

	write_text("m.xml", "<machine version='1' units='mm'><setup units='inch' initial_tool='2'>"
			    "<work_offset name='G55' X='1' C='90'/><fixture name='vise' mesh='v.stl' location='1 0 0'/>"
			    "<tool number='2' length='1'><cutter><section length='1' "
			    "diameter='1'/></cutter></tool></setup><base>" AXIS_X
			    "><spindle location='0 0 100' direction='0 0 -1'/></axis>" AXIS_C
			    "><workholding location='0 0 7'/></axis></base></machine>");
	m = load_good("m.xml");
	ck_assert_ptr_nonnull(m->setup);
	ck_assert_int_eq(m->setup->initial_tool, 2);
	ck_assert_str_eq(m->setup->bodies[0].name, "vise");
	ck_assert_int_eq(m->setup->bodies[0].link, 2);
	ck_assert_double_eq(m->setup->bodies[0].scale, 25.4);
	assert_vec3(m->setup->bodies[0].placement.translation, 25.4, 0, 7);
	ck_assert_int_eq(m->setup->bodies[1].link, 1);
	assert_vec3(m->setup->bodies[1].placement.translation, 0, 0, 100);
	ck_assert_double_eq_tol(m->setup->offsets[0].value.v[SLOT_X], 25.4, 1e-12);
	ck_assert_double_eq_tol(m->setup->offsets[0].value.v[SLOT_C], PI / 2, 1e-12);
	machine_free(m);
}
END_TEST

/* Every preset of every control is read, and answers the questions that the file leaves open. */
START_TEST(presets)
{
	int count = 0;

	for (int row = 0; dialect_names[row]; row++) {
		const struct control_preset *preset = dialect_rows[row].presets;

		for (; preset && preset->name; preset++, count++) {
			struct machine *m;
			char text[512];

			ck_assert_ptr_nonnull(preset->source);
			snprintf(text, sizeof(text),
				 MACHINE("<controller dialect='%s' preset='%s' power_on_plane='yz'/><base><axis name='X' "
					 "type='linear' direction='1 0 0' rate_max='6000'/></base>"),
				 dialect_names[row], preset->name);
			write_text("m.xml", text);
			m = load_good("m.xml");
			ck_assert_int_eq(m->controller.g53_with_g91, preset->g53_with_g91);
			ck_assert_int_eq(m->controller.comp_corner, preset->comp_corner);
			ck_assert_int_eq(m->controller.power_on_distance, preset->power_on_distance);
			ck_assert_int_eq(m->controller.power_on_plane, POWER_ON_YZ);
			machine_free(m);
		}
	}
	ck_assert_int_eq(count, 7);
}
END_TEST

START_TEST(limits_have_a_tolerance)
{
	struct machine *m;

	write_text("m.xml", BASE(AXIS_X " limit_min='0.0000009' limit_max='5'/>" AXIS_C
				       " limit_min='-90' limit_max='-0.0000009'/>"));
	m = load_good("m.xml");
	machine_free(m);
}
END_TEST

START_TEST(reads_other_encodings)
{
	struct machine *m;

	write_text(
	    "m.xml",
	    "<?xml version='1.0' encoding='ISO-8859-1'?>\n<machine version='1' name='Fr\xe4se'><base/></machine>");
	m = load_good("m.xml");
	ck_assert_str_eq(m->name, "Fr\xc3\xa4se");
	machine_free(m);
	write_text(
	    "m.xml",
	    "\xef\xbb\xbf<?xml version='1.0'?><!-- ====== <x a='> --><machine version='1' name='>='><base/></machine>");
	m = load_good("m.xml");
	ck_assert_str_eq(m->name, ">=");
	machine_free(m);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("machine");

	tcase_add_test(tcase, reads_axes);
	tcase_add_test(tcase, reads_bodies_and_mounts);
	tcase_add_test(tcase, reads_every_dialect);
	tcase_add_test(tcase, reads_controller_and_pairs);
	tcase_add_test(tcase, defaults);
	tcase_add_test(tcase, inches);
	tcase_add_test(tcase, mesh_beside_its_file);
	tcase_add_test(tcase, setup_inside);
	tcase_add_test(tcase, reads_other_encodings);
	tcase_add_test(tcase, presets);
	tcase_add_test(tcase, limits_have_a_tolerance);
	return run_in_folders("machine", tcase);
}
