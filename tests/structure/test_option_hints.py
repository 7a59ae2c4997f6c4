"""What core says where the studio shows it, too, names options of the command line in brackets only, which the studio
leaves out: "align the photographs (--align on)". See core/base/option_hints.h."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = ('capture', 'image', 'sandbox', 'solve')
TEXT = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')


def texts(source):
    """Its string literals, those that the compiler joins as one."""
    lines = '\n'.join('' if line.lstrip().startswith(('//', '#include')) else line for line in source.split('\n'))
    return [re.sub(r'"\s*"', '', literal)[1:-1] for literal in TEXT.findall(lines)]


def bare_options(text):
    return re.findall(r'--[a-z][a-z-]*', re.sub(r' \(--[^)]*\)', '', text))


class OptionHintsTest(unittest.TestCase):
    def test_options_are_found_outside_of_their_brackets_only(self):
        self.assertEqual(bare_options('Scale it (--memory of solve does without), or use --model auto.'), ['--model'])
        self.assertEqual(texts('say("one "\n    "text", "more");'), ['one text', 'more'])

    def test_core_names_options_in_brackets(self):
        for room in ROOMS:
            for file in sorted((ROOT / 'core' / room).rglob('*.cpp')):
                for text in texts(file.read_text()):
                    with self.subTest(f'{file.relative_to(ROOT)}: {text}'):
                        self.assertEqual(bare_options(text), [])


if __name__ == '__main__':
    unittest.main()
