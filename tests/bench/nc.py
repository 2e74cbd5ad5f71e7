"""nc.py - programs in straight moves, and the path that they mean: the times are computed here, not by fivecheck."""
import math


class Axis:
    def __init__(self, letter, rotary, rate, home=0.0):
        self.letter, self.rotary, self.rate, self.home = letter, rotary, rate, home


class Program:
    """G0 and G1 in absolute mm and degrees; rates and feeds in mm and degrees a minute."""

    def __init__(self, axes, feed, path=None, head=()):
        self.axes = {a.letter: a for a in axes}
        self.lines = ['G21 G90 G94 G54'] + list(head)
        self.feed_rate = feed
        self.at = {a.letter: a.home for a in axes}
        self.time = 0.0
        self.path = path    # keep it
        self.rows = []
        self.code = None
        self.mode = 94
        self.feed_word = True

    def move(self, code, seconds, words):
        text = 'G%d' % code if code != self.code else ''
        for letter, value in words.items():
            text += ' %s%.6f' % (letter, value)
        if code == 1 and self.feed_word:
            text += ' F%g' % self.feed_rate
            self.feed_word = False
        self.code = code
        self.lines.append(text.strip())
        self.at.update(words)
        self.time += seconds
        if self.path and seconds > 0:
            self.rows.append([len(self.lines), 1, 0] + [self.at[x] for x in self.axes] + [self.time, 0])

    def slowest(self, words):
        return max(abs(v - self.at[x]) / self.axes[x].rate * 60 for x, v in words.items())

    def rapid(self, **words):
        words = {x: round(v, 6) for x, v in words.items()}
        self.move(0, self.slowest(words), words)

    def timed(self, seconds, **words):
        """G93: the block takes so many seconds, or as long as its slowest axis."""
        words = {x: round(v, 6) for x, v in words.items()}
        inverse = round(60 / seconds, 3)
        if self.mode != 93:
            self.lines.append('G93')
            self.mode = 93
        self.code = 1
        self.lines.append('G1 ' + ' '.join('%s%.6f' % pair for pair in words.items()) + ' F%.3f' % inverse)
        self.time += max(60 / inverse, self.slowest(words))
        self.at.update(words)

    def feed(self, **words):
        words = {x: round(v, 6) for x, v in words.items()}
        way = math.sqrt(sum((v - self.at[x]) ** 2 for x, v in words.items() if x in 'XYZ'))
        if not way > 0:
            way = math.sqrt(sum((v - self.at[x]) ** 2 for x, v in words.items()))
        self.move(1, max(way / self.feed_rate * 60, self.slowest(words)), words)

    def write(self, program):
        with open(program, 'w') as out:
            out.write('\n'.join(self.lines) + '\nM2\n')
        if self.path:
            with open(self.path, 'w') as out:
                out.write('\t'.join(['line', 'move', 'tool'] + list(self.axes) + ['time', 'deviation']) + '\n')
                for row in self.rows:
                    out.write('\t'.join('%.12g' % x for x in row) + '\n')
