"""scene.py - a machine, a setup, a program, and what is known of them beforehand."""
import os

import plain


class Scene:
    """Files in a folder; `known` are the earliest and latest time of the first contact where a formula tells it,
    'clear' where one tells that there is none, or None. `slack` mm: bodies of fivecheck may be larger by that."""

    def __init__(self, name, folder, machine, setup, program, path=None, known=None, slack=0.0, **figures):
        self.name, self.folder, self.machine, self.setup, self.program = name, folder, machine, setup, program
        self.path, self.known, self.slack, self.figures = path, known, slack, figures
        self.plain = None

    def operands(self):
        return (['-s', self.setup] if self.setup else []) + [self.machine]

    def prepare(self, tools):
        """Writes the plain scene and, unless the generator did, the path."""
        if self.plain:
            return
        os.makedirs(self.folder, exist_ok=True)
        pairs = tools.run([tools.fivecheck, '--list-pairs'] + self.operands())
        if pairs.status:
            raise SystemExit('bench: %s: %s' % (self.name, pairs.err))
        self.plain = plain.write(self.machine, self.setup, pairs.out, self.folder)
        if not self.path:
            self.path = os.path.join(self.folder, 'path.tsv')
            tools.check(self, ['--dump-path', '--tolerance', '0.0005', '-q', '-o', self.path])
