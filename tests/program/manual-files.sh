# fivecheck-machine(5) has a section for every element of the schemas, with every attribute of it, and no other.
need python3
root=$(dirname "$LIB")/../..
cat >compare.py <<'PY'
import re
import sys
import xml.etree.ElementTree as ET

ROOT = sys.argv[1]
RNG = '{http://relaxng.org/ns/structure/1.0}'


def schema_attributes():
    """The names of the attributes that the schemas allow, for each name of an element."""
    found, defines, elements = {}, {}, []
    for name in ('machine', 'setup', 'jobs', 'waivers'):
        tree = ET.parse(f'{ROOT}/src/machine/xml/{name}.rng')
        defines.update((node.get('name'), node) for node in tree.iter(RNG + 'define'))
        elements += tree.iter(RNG + 'element')

    def attributes(node):
        for child in node:
            if child.tag == RNG + 'attribute':
                yield child.get('name')
            elif child.tag == RNG + 'ref':
                yield from attributes(defines[child.get('name')])
            elif child.tag != RNG + 'element':
                yield from attributes(child)

    for element in elements:
        found.setdefault(element.get('name'), set()).update(attributes(element))
    return found


def page_attributes():
    """The same from the page; and the elements that may have checked."""
    text = open(f'{ROOT}/man/fivecheck-machine.5').read()
    found, names = {}, []
    for line in text.splitlines():
        if line.startswith(('.Ss ', '.Sh ')):
            names = line[4:].split(' , ')
            for name in names:
                found.setdefault(name, set())
        elif line.startswith('.It Ar '):
            for name in names:
                found[name].update(line[7:].split(' , '))
    section = text[text.index('The elements\n.Ic base'):text.index('.Sh MACHINE FILES')]
    checked = re.findall(r'\w+', ' '.join(re.findall(r'^\.Ic (.*)', section, re.M)))
    return found, set(checked)


schema = schema_attributes()
page, checked = page_attributes()
# The page says "attributes as for fixture" and "the same attributes as tool_change".
page['part'] |= page['fixture']
page['swivel_retract'] |= page['tool_change']
for element in sorted(schema):
    if element not in page:
        print('no section:', element)
        continue
    wanted, has = schema[element], page[element]
    if ('checked' in wanted) != (element in checked):
        print('checked:', element)
    for name in sorted((wanted - has) - {'checked'}):
        print(f'not in the section {element}: {name}')
    for name in sorted(has - wanted):
        print(f'only in the section {element}: {name}')
PY
python3 compare.py "$root"
