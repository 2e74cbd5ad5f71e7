#include "import/jobs_writer.h"

#include "base/xml_text.h"

void jobs_writer_setup_name(struct strbuf *out, const struct import_project *project, size_t setup)
{
	if (project->setup_count == 1)
		strbuf_addf(out, "setup.xml");
	else
		strbuf_addf(out, "setup-%s.xml", project->setups[setup].name);
}

static void add_job(struct strbuf *out, const struct import_project *project, size_t index)
{
	const struct import_setup *setup = &project->setups[index];
	struct strbuf file = {0};

	jobs_writer_setup_name(&file, project, index);
	strbuf_addf(out, "  <job");
	xml_text_attribute(out, "name", setup->name);
	xml_text_attribute(out, "machine", "machine.xml");
	xml_text_attribute(out, "setup", strbuf_text(&file));
	strbuf_addf(out, ">\n");
	for (size_t i = 0; i < setup->program_count; i++) {
		strbuf_addf(out, "    <program");
		xml_text_attribute(out, "file", setup->programs[i]);
		strbuf_addf(out, "/>\n");
	}
	strbuf_addf(out, "  </job>\n");
	strbuf_release(&file);
}

bool jobs_writer_xml(struct strbuf *out, const struct import_project *project, const char *origin)
{
	size_t programs = 0;

	for (size_t i = 0; i < project->setup_count; i++)
		programs += project->setups[i].program_count;
	if (!programs)
		return false;
	strbuf_addf(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
	xml_text_comment(out, origin);
	strbuf_addf(out, "<jobs version=\"1\">\n");
	for (size_t i = 0; i < project->setup_count; i++)
		if (project->setups[i].program_count)
			add_job(out, project, i);
	strbuf_addf(out, "</jobs>\n");
	return true;
}
