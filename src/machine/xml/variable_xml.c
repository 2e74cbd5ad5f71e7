#include "machine/xml/variable_xml.h"

#include "control/controller.h"
#include "machine/xml/xml_attribute.h"
#include "machine/xml/xml_element.h"

void variable_xml_read(struct xml_reader *xml, const xmlNode *node, struct arena *arena,
		       struct variable_description *variable)
{
	static const char *const types[] = {
		[CONTROL_REAL] = "REAL", [CONTROL_INT] = "INT",	      [CONTROL_BOOL] = "BOOL", [CONTROL_CHAR] = "CHAR",
		[CONTROL_STRING] = "STRING", [CONTROL_AXIS] = "AXIS", NULL,
	};

	xml_require(xml, node, "name", NULL);
	*variable = (struct variable_description){
		.at = node,
		.name = xml_name(xml, node, "name", arena),
		.value = xml_label(xml, node, "value", arena),
		.size = xml_label(xml, node, "size", arena),
		.type = xml_choice(xml, node, "type", types, -1),
	};
	xml_read_nothing(xml, node);
}
