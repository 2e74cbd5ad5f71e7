/* xml_file.h - reads and parses an XML file safely, even if the file is hostile. */
#ifndef FIVECHECK_MACHINE_XML_XML_FILE_H
#define FIVECHECK_MACHINE_XML_XML_FILE_H

#include <stdbool.h>

#include "machine/xml/xml_reader.h"

/*
 * Reads and parses xml->path, or xml->text if it is there: sets the reader's document, bytes and tags. No network, no
 * entities, no document type. False, reported: xml_reader_release releases what was set so far.
 */
bool xml_file_parse(struct xml_reader *xml);

#endif
