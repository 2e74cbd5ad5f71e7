/*
 * test_schema.c - the schemas describe what the readers read: schema and reader accept the valid files, and of
 * thousands of damaged files the readers refuse all that the schema refuses.
 */
#include <libxml/parser.h>
#include <libxml/relaxng.h>
#include <libxml/tree.h>

#include "machine/job_list.h"
#include "machine/setup.h"
#include "machine/waivers.h"
#include "machine_case.h"

static const char setup_text[] =
	"<setup version='1' units='mm' initial_tool='12'>\n"
	"<work_offset name='G54' X='1' C='-90'/><work_offset name='G59.3'/>\n"
	"<tool number='12' name='ball 10' length='130' length_offset='129.5' diameter='10' kind='probe'>\n"
	"<cutter tip='ball' flute_length='20'><section length='40' diameter='10'/></cutter>\n"
	"<holder><section length='30' diameter='63'/><section length='35' diameter='40' diameter_end='32'/></holder>\n"
	"<shank><section length='25' diameter='10'/></shank></tool>\n"
	"<tool number='2' length='50'><cutter tip='cone' angle='90'><section length='50' diameter='6'/></cutter></tool>\n"
	"<tool number='4' length='50'><cutter tip='bull' corner='1'><section length='50' diameter='6'/></cutter></tool>\n"
	"<part name='blade' mesh='blade.stl' location='0 0 60' units='m' rapid_allowance='0.2' gouge='0.1'/>\n"
	"<fixture name='vise' mesh='/v/vise.stl' rotation='0 0 90'/>\n"
	"<tool number='3' length='80' diameter='6'><cutter mesh='c.stl' units='inch'/>\n"
	"<holder><section length='20' diameter='40'/></holder><shank mesh='s.stl'/></tool>\n"
	"<offset number='12' length='131'/><offset number='7' length='-5'/>\n"
	"<tools href='more.csv' units='inch' numbers='20-29'/>\n"
	"</setup>";

static const char jobs_text[] =
	"<jobs version='1'>\n"
	"<job name='op10' machine='m.xml' setup='s.xml' waivers='w.xml'><program file='a.nc'/><program file='b.nc'/></job>\n"
	"<job name='op20' machine='m.xml'><program file='c.nc'/></job>\n"
	"</jobs>";

static const char waivers_text[] =
	"<waivers version='1'>\n"
	"<waiver program='p.nc' kind='collision' a='head' b='bed' reason='r' block='G0' within='0.1' times='2'\n"
	" axes='X1 Y2 A3 C4' expires='2030-01-31'/>\n"
	"<waiver program='p.nc' kind='limit' axis='X' reason='r' block='G0' axes='X1 Y2 A3 C4' expires='2030-01-31'/>\n"
	"</waivers>";

/* The properties of the control are attributes of one element: a schema must not try every selection of them. */
static const char questions_text[] =
	"<machine version='1'>\n"
	"<controller dialect='haas' length_after_reference='cancels' g53_with_g91='incremental' power_on_units='inch'\n"
	" power_on_distance='incremental' power_on_plane='yz' m6_with_move='before' m6_with_t='own'\n"
	" length_under_g68='turned' semicolon='comment' colon='block' cutter_comp_d='radius' cutter_comp_start='A'\n"
	" cutter_comp_corner='linear' cycle_repeats='K' arc_radius_tolerance='0.01'>\n"
	"<macro program='9810' action='move'/><macro program='9811' code='107' action='around' X='1' Z='2'/>"
	"<variable name='#500' value='1.5'/></controller>\n"
	"<base><axis name='X' type='linear' direction='1 0 0' rate_max='6000'/></base>\n"
	"</machine>";

/* The second machine file is the trunnion of machine_case.h, with a setup inside. */
static struct strbuf machine_text;

enum kind { MACHINE_FILE, QUESTIONS_FILE, SETUP_FILE, JOBS_FILE, WAIVERS_FILE, KINDS };

static xmlRelaxNG *schemas[KINDS];
static struct machine *machine;

static const char *text_of(enum kind kind)
{
	switch (kind) {
	case MACHINE_FILE:
		return strbuf_text(&machine_text);
	case QUESTIONS_FILE:
		return questions_text;
	case SETUP_FILE:
		return setup_text;
	case JOBS_FILE:
		return jobs_text;
	case WAIVERS_FILE:
	case KINDS:
		break;
	}
	return waivers_text;
}

static bool reader_accepts(enum kind kind)
{
	struct diag diag = {0};
	bool good = false;

	if (kind == MACHINE_FILE || kind == QUESTIONS_FILE) {
		struct machine *read = machine_load("m.xml", &diag);

		good = read;
		machine_free(read);
	} else if (kind == SETUP_FILE) {
		struct setup *read = setup_load("m.xml", machine, &diag);

		good = read;
		setup_free(read);
	} else if (kind == JOBS_FILE) {
		struct job_list read = {0};

		good = job_list_load(&read, "m.xml", &diag);
		job_list_release(&read);
	} else {
		struct waivers *read = waivers_load("m.xml", machine, &diag);

		good = read;
		waivers_free(read);
	}
	ck_assert(good == (diag.errors == 0));
	return good;
}

static bool schema_accepts(enum kind kind, xmlDoc *doc)
{
	xmlRelaxNGValidCtxt *context = xmlRelaxNGNewValidCtxt(schemas[kind]);
	int result;

	xmlRelaxNGSetValidErrors(context, NULL, NULL, NULL);
	result = xmlRelaxNGValidateDoc(context, doc);
	ck_assert_int_ge(result, 0);
	xmlRelaxNGFreeValidCtxt(context);
	return result == 0;
}

static void silence(void *context, const char *format, ...)
{
	(void)context;
	(void)format;
}

/* Tests run in another folder, so relative paths would not lead to the schemas. */
static void load_schemas(void)
{
	static const char *const names[KINDS] = {"machine.rng", "machine.rng", "setup.rng", "jobs.rng",
						 "waivers.rng"};
	char path[4200], here[4096];

	/* Outside of a test, assertions of libcheck are not possible. */
	if (!getcwd(here, sizeof(here)))
		abort();
	xmlSetGenericErrorFunc(NULL, silence);
	for (int i = 0; i < KINDS; i++) {
		xmlRelaxNGParserCtxt *parser;

		snprintf(path, sizeof(path), "%s/src/machine/xml/%s", here, names[i]);
		parser = xmlRelaxNGNewParserCtxt(path);
		schemas[i] = parser ? xmlRelaxNGParse(parser) : NULL;
		if (!schemas[i]) {
			fprintf(stderr, "%s is no schema\n", path);
			abort();
		}
		xmlRelaxNGFreeParserCtxt(parser);
	}
}

static void free_schemas(void)
{
	for (int i = 0; i < KINDS; i++)
		xmlRelaxNGFree(schemas[i]);
}

static void start(void)
{
	const char *end = strstr(trunnion, "</machine>");
	const char *questions = strstr(trunnion, " length_after_reference="), *rest = strstr(questions, ">");

	enter_folder();
	write_text("m.xml", trunnion);
	write_text("more.csv", "number,length_offset\n20,5\n7,-5\n");
	machine = load_good("m.xml");
	strbuf_add(&machine_text, trunnion, (size_t)(questions - trunnion));
	strbuf_add(&machine_text, rest, (size_t)(end - rest));
	/* Without some answers of the control, and with a setup inside. */
	strbuf_addf(&machine_text, "<setup units='inch'><work_offset name='G55' X='1'/></setup></machine>\n");
}

static void finish(void)
{
	machine_free(machine);
	strbuf_release(&machine_text);
	unlink("more.csv");
	leave_folder();
}

/* ------------------------------------------------------------------ damage */

struct tally {
	long cases, refused_by_schema, refused_by_reader;
};

static void judge(enum kind kind, xmlDoc *doc, const char *what, struct tally *tally)
{
	bool by_schema, by_reader;
	xmlChar *bytes;
	int length;

	xmlDocDumpMemory(doc, &bytes, &length);
	write_bytes("m.xml", (const char *)bytes, (size_t)length);
	by_schema = !schema_accepts(kind, doc);
	by_reader = !reader_accepts(kind);
	ck_assert_msg(!by_schema || by_reader, "the schema refuses what the reader takes: %s\n%s", what, bytes);
	xmlFree(bytes);
	tally->cases++;
	tally->refused_by_schema += by_schema;
	tally->refused_by_reader += by_reader;
}

/* The n-th element in the order of the file, or NULL. */
static xmlNode *find_element(xmlNode *node, int *n)
{
	for (; node; node = node->next) {
		xmlNode *found;

		if (node->type != XML_ELEMENT_NODE)
			continue;
		if ((*n)-- == 0)
			return node;
		found = find_element(node->children, n);
		if (found)
			return found;
	}
	return NULL;
}

static xmlNode *open_case(enum kind kind, int element, xmlDoc **doc)
{
	*doc = xmlReadMemory(text_of(kind), (int)strlen(text_of(kind)), NULL, NULL, 0);
	ck_assert_ptr_nonnull(*doc);
	return find_element(xmlDocGetRootElement(*doc), &element);
}

static xmlAttr *find_attribute(xmlNode *node, int n)
{
	xmlAttr *attribute = node->properties;

	while (attribute && n-- > 0)
		attribute = attribute->next;
	return attribute;
}

static const char *const values[] = {"", "x", "-1", "0", "1.5", "7", "1 2 3", "1 2", "nan", "1e999", "mm", "limit", "X"};
enum { VALUES = COUNT(values) };

/* Each attribute is removed, renamed, and given each of the values. */
START_TEST(attributes)
{
	enum kind kind = (enum kind)_i;
	struct tally tally = {0};
	xmlNode *node;
	xmlDoc *doc;

	for (int element = 0;; element++) {
		bool more = true;

		for (int n = 0; more; n++) {
			for (int how = 0; how < VALUES + 2; how++) {
				xmlAttr *attribute;

				node = open_case(kind, element, &doc);
				attribute = node ? find_attribute(node, n) : NULL;
				more = attribute != NULL;
				if (attribute && how == VALUES)
					xmlRemoveProp(attribute);
				else if (attribute && how == VALUES + 1)
					xmlNodeSetName((xmlNode *)attribute, BAD_CAST "lenght");
				else if (attribute)
					xmlSetProp(node, attribute->name, BAD_CAST values[how]);
				if (attribute)
					judge(kind, doc, "an attribute", &tally);
				xmlFreeDoc(doc);
			}
		}
		if (!node)
			break;
	}
	ck_assert_int_gt(tally.cases, 100);
	ck_assert_int_gt(tally.refused_by_schema, tally.cases / 5);
	ck_assert_int_lt(tally.refused_by_reader, tally.cases);
}
END_TEST

/* Each element is removed, doubled, renamed, moved, and given a text, an attribute or a child that it must not have. */
START_TEST(elements)
{
	enum kind kind = (enum kind)_i;
	struct tally tally = {0};
	xmlNode *node;
	xmlDoc *doc;

	for (int element = 0;; element++) {
		for (int how = 0; how < 8; how++) {
			node = open_case(kind, element, &doc);
			if (!node || (node == xmlDocGetRootElement(doc) && (how < 2 || how == 6))) {
				xmlFreeDoc(doc);
				continue;
			}
			if (how == 0) {
				xmlUnlinkNode(node);
				xmlFreeNode(node);
			} else if (how == 1) {
				xmlAddNextSibling(node, xmlCopyNode(node, 1));
			} else if (how == 2) {
				xmlNodeSetName(node, BAD_CAST "widget");
			} else if (how == 3) {
				xmlAddChild(node, xmlNewText(BAD_CAST "text"));
			} else if (how == 4) {
				xmlNewProp(node, BAD_CAST "colour", BAD_CAST "red");
			} else if (how == 5) {
				xmlNewChild(node, NULL, BAD_CAST "widget", NULL);
			} else if (how == 6) {
				xmlUnlinkNode(node);
				xmlAddChild(xmlDocGetRootElement(doc), node);
			} else {
				xmlSetNs(node, xmlNewNs(node, BAD_CAST "http://example.org/", NULL));
			}
			judge(kind, doc, "an element", &tally);
			xmlFreeDoc(doc);
		}
		if (!node)
			break;
	}
	ck_assert_int_gt(tally.cases, 10);
	ck_assert_int_gt(tally.refused_by_schema, tally.cases / 2);
	ck_assert_int_lt(tally.refused_by_reader, tally.cases);
}
END_TEST

/* The elements of <controller> in any order: schema and reader agree on each of these cases. */
static const struct {
	const char *within;
	bool good;
} controllers[] = {
	{"<macro program='9810' action='none'/><tool_change/><macro code='107' action='none'/>", true},
	{"<tool_change/><mcode number='90' action='ignore'/><tool_change/>", false},
	{"<macro action='none'/>", false},
};

START_TEST(controller)
{
	struct strbuf text = {0};
	struct tally tally = {0};
	xmlDoc *doc;

	strbuf_addf(&text,
		    "<machine version='1'><controller dialect='klartext'>%s</controller>"
		    "<base><axis name='X' type='linear' direction='1 0 0' rate_max='6000'/></base></machine>",
		    controllers[_i].within);
	doc = xmlReadMemory(strbuf_text(&text), (int)text.length, NULL, NULL, 0);
	judge(MACHINE_FILE, doc, "a controller", &tally);
	ck_assert_int_eq(tally.refused_by_schema, !controllers[_i].good);
	ck_assert_int_eq(tally.refused_by_reader, !controllers[_i].good);
	xmlFreeDoc(doc);
	strbuf_release(&text);
}
END_TEST

START_TEST(good_files)
{
	enum kind kind = (enum kind)_i;
	struct tally tally = {0};
	xmlDoc *doc;

	open_case(kind, 0, &doc);
	judge(kind, doc, "nothing", &tally);
	xmlFreeDoc(doc);
	ck_assert_int_eq(tally.refused_by_schema + tally.refused_by_reader, 0);
}
END_TEST

int main(void)
{
	TCase *tcase = tcase_create("schema");
	int status;

	load_schemas();
	tcase_add_checked_fixture(tcase, start, finish);
	tcase_add_loop_test(tcase, good_files, 0, KINDS);
	tcase_add_loop_test(tcase, controller, 0, COUNT(controllers));
	tcase_add_loop_test(tcase, attributes, 0, KINDS);
	tcase_add_loop_test(tcase, elements, 0, KINDS);
	status = run_suite("schema", tcase);
	free_schemas();
	return status;
}
