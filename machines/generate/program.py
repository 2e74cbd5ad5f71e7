"""Writes NC programs as a CAM postprocessor does: numbered blocks, modal words, a comment before each operation."""
import math


def number(value):
    text = '%.3f' % round(value, 7)
    text = text.rstrip('0')
    return '0.' if text in ('-0.', '0.') else text


class Program:
    def __init__(self, title, *notes):
        self.lines = ['%', '(%s)' % title] + ['(%s)' % n for n in notes]
        self.block = 0
        self.modal = {}

    def add(self, text):
        self.block += 10
        self.lines.append('N%d %s' % (self.block, text))

    def comment(self, text):
        self.lines.append('(%s)' % text)

    def forget(self):
        """Forgets the modal words, because the axes have moved elsewhere."""
        self.modal = {}

    def move(self, code, feed=None, **words):
        """Adds a motion block with the words that change."""
        out = []
        if self.modal.get('G') != code:
            out.append('G%d' % code)
        for axis in 'XYZABC':
            if axis in words:
                text = number(words[axis])
                if self.modal.get(axis) != text:
                    out.append(axis + text)
                    self.modal[axis] = text
        if len(out) == (self.modal.get('G') != code):
            return
        self.modal['G'] = code
        if feed and self.modal.get('F') != feed:
            out.append('F%d' % feed)
            self.modal['F'] = feed
        self.add(' '.join(out))

    def rapid(self, **words):
        self.move(0, **words)

    def feed(self, rate, **words):
        self.move(1, rate, **words)

    def start(self):
        self.add('G21 G17 G40 G49 G61 G80 G90 G94')
        self.retract()

    def retract(self):
        self.add('G53 G0 Z0.')
        self.forget()

    def tool(self, t, name, speed):
        self.comment('TOOL %d: %s' % (t, name.upper()))
        self.add('T%d M6' % t)
        self.add('S%d M3' % speed)
        self.add('G54')

    def tcp(self, t):
        self.add('G43.4 H%d' % t)
        self.forget()

    def end(self):
        self.add('M5')
        self.add('M30')
        self.lines.append('%')

    def text(self):
        return '\n'.join(self.lines) + '\n'


def near(angle, last):
    """The angle plus whole turns, as near to the last angle as possible."""
    return angle + 360 * math.floor((last - angle) / 360 + 0.5)


def add(p, s, q):
    return tuple(a + s * b for a, b in zip(p, q))


def unit3(v):
    d = math.sqrt(sum(a * a for a in v))
    return tuple(a / d for a in v)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def azimuth(v):
    return math.degrees(math.atan2(v[1], v[0]))


def polar(v):
    return math.degrees(math.atan2(math.hypot(v[0], v[1]), v[2]))
