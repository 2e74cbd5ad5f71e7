/* files.cpp - writes a machine as the files that fivecheck reads. */
#include <fstream>
#include <stdexcept>

#include "machine.h"

static std::string text_of(vec v)
{
	char text[128];

	std::snprintf(text, sizeof(text), "%.17g %.17g %.17g", v.x, v.y, v.z);
	return text;
}

static std::string text_of(double value)
{
	char text[32];

	std::snprintf(text, sizeof(text), "%.17g", value);
	return text;
}

static void write_body(std::ostream &xml, const char *element, const Machine &machine, size_t i,
		       const std::string &folder)
{
	const Body &body = machine.bodies[i];
	std::string mesh = "body-" + std::to_string(i) + ".stl";

	write_stl(folder + "/" + mesh, body.drawn);
	xml << "<" << element << " name='" << body.name << "' mesh='" << mesh << "' location='"
	    << text_of(body.location) << "' rotation='" << text_of(body.turns) << "'/>\n";
}

static void write_link(std::ostream &xml, const Machine &machine, int link, const std::string &folder)
{
	for (size_t i = 0; i < machine.bodies.size(); i++)
		if (machine.bodies[i].link == link && machine.bodies[i].role == Role::MACHINE)
			write_body(xml, "body", machine, i, folder);
	if (link == machine.spindle)
		xml << "<spindle location='" << text_of(machine.gauge) << "' direction='"
		    << text_of(machine.tool_direction) << "'/>\n";
	if (link == machine.table)
		xml << "<workholding location='" << text_of(machine.work) << "'/>\n";
	for (int i = 0; i < machine.world.axis_count; i++) {
		const axis &axis = machine.world.axes[i];
		const Travel &travel = machine.travels[(size_t)i];

		if (axis.parent != link)
			continue;
		xml << "<axis name='" << axis.letter << "' type='" << (axis.rotary ? "rotary" : "linear")
		    << "' direction='" << text_of(axis.direction) << "' location='" << text_of(axis.location)
		    << "' limit_min='" << text_of(travel.low) << "' limit_max='" << text_of(travel.high)
		    << "' rate_max='" << text_of(60 * travel.rate) << "' home='" << text_of(axis.home) << "'>\n";
		write_link(xml, machine, i + 1, folder);
		xml << "</axis>\n";
	}
}

static void write_setup(std::ostream &xml, const Machine &machine, const std::string &folder)
{
	xml << "<setup version='1' units='mm'>\n";
	for (const Offset &offset : machine.offsets) {
		xml << "<work_offset name='" << offset.name << "'";
		for (int i = 0; i < machine.world.axis_count; i++)
			xml << " " << machine.world.axes[i].letter << "='" << text_of(offset.shift[(size_t)i]) << "'";
		xml << "/>\n";
	}
	for (size_t i = 0; i < machine.bodies.size(); i++) {
		if (machine.bodies[i].role == Role::FIXTURE)
			write_body(xml, "fixture", machine, i, folder);
		if (machine.bodies[i].role == Role::PART)
			write_body(xml, "part", machine, i, folder);
	}
	for (const Tool &tool : machine.tools)
		xml << "<tool number='" << tool.number << "' length='" << text_of(tool.length)
		    << "'>\n<holder><section length='" << text_of(tool.holder_length) << "' diameter='"
		    << text_of(tool.holder_diameter) << "'/></holder>\n<cutter tip='" << (tool.ball ? "ball" : "flat")
		    << "'><section length='" << decimal(tool.length - tool.holder_length, 2) << "' diameter='"
		    << text_of(tool.diameter) << "'/></cutter>\n</tool>\n";
	xml << "</setup>\n";
}

void write_machine(const Machine &machine, const std::string &folder)
{
	std::ofstream xml(folder + "/m.xml");

	xml << "<machine version='1' units='mm'>\n<controller dialect='" << machine.dialect << "' rapid='"
	    << machine.rapid << "'" << (machine.dialect == "linuxcnc" ? "" : " length_offset_moves='no' least_input='1'")
	    << (machine.dialect == "fanuc" ? " tool_length_axis='z'" : "") << "><tool_change/></controller>\n<base>\n";
	write_link(xml, machine, 0, folder);
	xml << "</base>\n</machine>\n";
	if (!xml.flush())
		throw std::runtime_error(folder + "/m.xml: cannot be written");
	if (machine.has_setup) {
		std::ofstream setup(folder + "/s.xml");

		write_setup(setup, machine, folder);
		if (!setup.flush())
			throw std::runtime_error(folder + "/s.xml: cannot be written");
	}
}
