/* xml_file.h - from a path to a well-formed document, however hostile the file. */
#ifndef FIVECHECK_MACHINE_XML_XML_FILE_H
#define FIVECHECK_MACHINE_XML_XML_FILE_H

#include <stdbool.h>

#include "machine/xml/xml_reader.h"

/*
 * Reads and parses xml->path: sets the reader's document, bytes and tags. No network, no entities, no document type.
 * False after a reported fault; what was set so far is released by xml_reader_release.
 */
bool xml_file_parse(struct xml_reader *xml);

#endif
