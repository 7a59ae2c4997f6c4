"""The links in the documents: every file and every heading that one points to is there."""
import pathlib
import re
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r'!?\[[^\]]*\]\(\s*<?([^)\s>]+)>?(?:\s+"[^"]*")?\s*\)|<(?:img|a)\s[^>]*?(?:src|href)="([^"]+)"')
ELSEWHERE = re.compile(r'[a-z][a-z0-9+.-]*:|//', re.I)


def prose(text):
    """Without code, where brackets are no links."""
    text = re.sub(r'^(```|~~~).*?^\1', '', text, flags=re.M | re.S)
    return re.sub(r'(`+)[^`].*?\1', '', text)


def anchors(file):
    """The names that headings have in links, as GitHub makes them: a second one of a name ends in -1."""
    seen, names = {}, set()
    text = re.sub(r'^(```|~~~).*?^\1', '', file.read_text(), flags=re.M | re.S)
    for heading in re.findall(r'^#{1,6}\s+(.+?)\s*#*$', text, flags=re.M):
        words = re.sub(r'!?\[([^\]]*)\]\([^)]*\)', r'\1', heading)
        name = re.sub(r'[^\w\- ]', '', words.lower()).replace(' ', '-')
        number = seen.get(name, 0)
        seen[name] = number + 1
        names.add(f'{name}-{number}' if number else name)
    return names | set(re.findall(r'<a\s+(?:id|name)="([^"]+)"', text))


def documents(root):
    return sorted(f for f in root.rglob('*.md')
                  if not any(part.startswith('.') or part == 'build' for part in f.relative_to(root).parts))


def broken_links(root):
    broken = []
    for document in documents(root):
        for match in LINK.finditer(prose(document.read_text())):
            target = match[1] or match[2]
            if ELSEWHERE.match(target):
                continue
            path, _, anchor = target.partition('#')
            file = (document.parent / path).resolve() if path else document
            where = f'{document.relative_to(root)}: {target}'
            if not file.exists():
                broken.append(f'{where}: no such file')
            elif not file.is_relative_to(root.resolve()):
                broken.append(f'{where}: lies outside of the project')
            elif anchor and file.suffix == '.md' and anchor not in anchors(file):
                broken.append(f'{where}: no such heading; there are {", ".join(sorted(anchors(file)))}')
    return broken


class ProjectTest(unittest.TestCase):
    def test_there_are_documents_with_links(self):
        found = documents(ROOT)
        self.assertGreater(len(found), 10)
        self.assertGreater(sum(len(LINK.findall(prose(f.read_text()))) for f in found), 20)

    def test_every_link_leads_somewhere(self):
        broken = broken_links(ROOT)
        self.assertFalse(broken, '\n' + '\n'.join(broken))


class PlantedTest(unittest.TestCase):
    def broken(self, text):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / 'docs').mkdir()
            (root / 'docs/a.md').write_text('# One: two, `three`\n\n## Again\n\n## Again\n\n```sh\n# no heading\n```\n')
            (root / 'README.md').write_text(text)
            return broken_links(root)

    def test_what_is_there_is_fine(self):
        self.assertEqual(self.broken('# Top\n[a](docs/a.md) [b](docs/a.md#one-two-three) [c](#top) '
                                     '[d](docs/a.md#again-1) [e](https://example.org/x) `[f](nowhere)`'), [])

    def test_what_is_missing_is_named(self):
        self.assertRegex(self.broken('see ![a](docs/b.png)')[0], r'README.md: docs/b.png: no such file')
        self.assertRegex(self.broken('[a](docs/a.md#no-heading)')[0], 'no such heading')
        self.assertRegex(self.broken('[a](../../etc/passwd)')[0], 'no such file|outside')
        self.assertRegex(self.broken('<img src="x.jpg">')[0], 'no such file')


if __name__ == '__main__':
    unittest.main()
