"""The architecture as the tree states it: which folder is which library, what it includes, what it links.

`problems(root)` returns what is wrong with the tree under a root, one line each. The rules:
  * folders of core, render, ui and app form no circles;
  * an include is named by the LINK line of the including folder's library, and a LINK line names nothing else;
  * core knows nothing of render, render nothing of ui, ui nothing of app;
  * every source is listed in a CMakeLists.txt;
  * core includes no graphics, render only OpenGL, and some rooms of ui no Dear ImGui, not even through others;
  * no folder, of the tests neither, has more than MOST_FILES files; pictures and other data may lie together.
"""
import collections
import pathlib
import re

LAYERS = ('core', 'render', 'ui', 'app')  # bottom up
MOST_FILES = 30
DATA = ('tests/data/', 'tests/samples/', 'tests/fuzz/seeds/', 'tests/studio/states/')

GRAPHICS = {  # what an include <...> begins with
    'Dear ImGui': ('imgui',),
    'GLFW': ('GLFW/', 'glfw'),
    'OpenGL': ('GL/', 'GLES', 'EGL/', 'epoxy/', 'KHR/'),
}
GRAPHICS_TARGETS = ('PkgConfig::IMGUI', 'imgui', 'glfw')
# Rooms of ui that work without a window: threads, documents, state. A unit test reaches them.
WITHOUT_IMGUI = ('ui/actions', 'ui/input', 'ui/state', 'ui/jobs', 'ui/pictures', 'ui/control')

KEYWORDS = ('SOURCES', 'KERNELS', 'LINK', 'PUBLIC', 'PRIVATE')
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)


class Library:
    """A call of swaplight_library(), or the program."""

    def __init__(self, name, folder, words):
        self.name = name
        self.folder = folder
        self.lists = {keyword: [] for keyword in KEYWORDS}
        keyword = 'SOURCES'
        for word in words:
            if word in self.lists:
                keyword = word
            else:
                self.lists[keyword].append(word)

    @property
    def sources(self):
        return {f'{self.folder}/{name}' for name in self.lists['SOURCES'] + self.lists['KERNELS']}

    @property
    def links(self):
        return self.lists['LINK']

    @property
    def others(self):
        return self.lists['PUBLIC'] + self.lists['PRIVATE']


def calls(text, command):
    """The words of every call of a CMake command."""
    text = re.sub(r'#[^\n]*', '', text)
    return [found.group(1).split() for found in re.finditer(command + r'\s*\(([^)]*)\)', text)]


class Tree:
    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.libraries = {}
        for layer in LAYERS:
            for file in sorted(self.root.glob(f'{layer}/**/CMakeLists.txt')):
                self._read_cmake(file)
        self.files = sorted(str(file.relative_to(self.root)) for layer in LAYERS
                            for file in self.root.glob(f'{layer}/**/*') if file.suffix in ('.h', '.cpp'))
        self.library_of = {source: library for library in self.libraries.values() for source in library.sources}
        self.includes = {file: self._includes_of(file) for file in self.files}

    def _read_cmake(self, file):
        text, folder = file.read_text(), str(file.parent.relative_to(self.root))
        for name, *words in calls(text, 'swaplight_library'):
            self.libraries[name] = Library(name, folder, words)
        for name, *words in calls(text, 'add_executable'):
            links = [word for target, *linked in calls(text, 'target_link_libraries') if target == name
                     for word in linked if word.startswith('swaplight_')]
            self.libraries[name] = Library(name, folder, words + ['LINK'] + links)

    def _includes_of(self, file):
        """(line, quoted, name) of each include."""
        text = (self.root / file).read_text()
        return [(text.count('\n', 0, found.start(1 if found.group(1) else 2)) + 1, bool(found.group(1)),
                 found.group(1) or found.group(2)) for found in INCLUDE.finditer(text)]

    def project_includes(self, file):
        return [(line, name) for line, quoted, name in self.includes[file] if quoted]


def folder_of(file):
    return file.rpartition('/')[0]


def layer_of(file):
    return file.partition('/')[0]


def unlisted(tree):
    for file in tree.files:
        if file not in tree.library_of:
            yield f'{file}: no CMakeLists.txt lists it: add it to SOURCES of the library of {folder_of(file)}'
    for library in tree.libraries.values():
        for source in sorted(library.sources - set(tree.files)):
            if source.endswith(('.h', '.cpp')):
                yield f'{source}: {library.folder}/CMakeLists.txt lists it, but there is no such file'


def crowded(tree):
    files = [str(file.relative_to(tree.root)) for top in (*LAYERS, 'tests', 'scripts', 'cmake')
             for file in tree.root.glob(f'{top}/**/*') if file.is_file() and '__pycache__' not in file.parts]
    counts = collections.Counter(folder_of(file) for file in files if not file.startswith(DATA))
    for folder, count in sorted(counts.items()):
        if count > MOST_FILES:
            yield f'{folder}: {count} files, at most {MOST_FILES}: it is two rooms'


def unnamed_includes(tree):
    for file in tree.files:
        library = tree.library_of.get(file)
        for line, name in tree.project_includes(file):
            if layer_of(name) not in LAYERS:
                yield f'{file}:{line}: "{name}": write the path from the project\'s root'
            elif name not in tree.includes:
                yield f'{file}:{line}: "{name}": there is no such file'
            elif LAYERS.index(layer_of(name)) > LAYERS.index(layer_of(file)):
                yield f'{file}:{line}: {layer_of(file)} must not know {layer_of(name)}: "{name}"'
            elif library and name in tree.library_of:
                other = tree.library_of[name]
                if other is not library and other.name not in library.links:
                    yield (f'{file}:{line}: "{name}" is of {other.name}, which LINK of {library.name} '
                           f'({library.folder}/CMakeLists.txt) does not name')


def idle_links(tree):
    """Links of which no header is included: the line would state an arrow that is not there."""
    for library in tree.libraries.values():
        used = {tree.library_of[name].name for file in library.sources if file in tree.includes
                for _, name in tree.project_includes(file) if name in tree.library_of}
        for link in library.links:
            if link in tree.libraries and link not in used:
                yield f'{library.folder}/CMakeLists.txt: {library.name} names {link} but includes nothing of it'


def arrows(tree):
    """folder -> {folder: "file:line includes name"} over the real includes."""
    found = collections.defaultdict(dict)
    for file in tree.files:
        for line, name in tree.project_includes(file):
            here, there = folder_of(file), folder_of(name)
            if here != there and name in tree.includes:
                found[here].setdefault(there, f'{file}:{line} includes {name}')
    return found


def way(graph, start, goal):
    """The shortest way along arrows, as a list of folders; None where there is none."""
    before, queue = {start: None}, collections.deque([start])
    while queue:
        here = queue.popleft()
        if here == goal:
            steps = [here]
            while before[steps[-1]] is not None:
                steps.append(before[steps[-1]])
            return steps[::-1]
        for there in sorted(graph.get(here, ())):
            if there not in before:
                before[there] = here
                queue.append(there)
    return None


def circles(tree):
    graph, told = arrows(tree), set()
    for here in sorted(graph):
        for there in sorted(graph[here]):
            back = way(graph, there, here)
            if back is None or frozenset(back) in told:
                continue
            told.add(frozenset(back))
            reasons = [graph[a][b] for a, b in zip([here] + back, back)]
            yield 'circle ' + ' -> '.join([here] + back) + ': ' + '; '.join(reasons)


def forbidden_graphics(file):
    if layer_of(file) in ('core', 'app'):
        return ('Dear ImGui', 'GLFW', 'OpenGL')
    if layer_of(file) == 'render':
        return ('Dear ImGui', 'GLFW')
    if folder_of(file) in WITHOUT_IMGUI:
        return ('Dear ImGui', 'GLFW', 'OpenGL')
    return ('OpenGL',) if folder_of(file) == 'ui/window' else ('GLFW', 'OpenGL')


def graphics_includes(tree):
    for file in tree.files:
        for line, _, name in tree.includes[file]:
            for what in forbidden_graphics(file):
                if name.startswith(GRAPHICS[what]):
                    yield f'{file}:{line}: {folder_of(file)} must not include {what}: {name}'


def graphics_links(tree):
    for library in tree.libraries.values():
        if library.folder not in WITHOUT_IMGUI and layer_of(library.folder) != 'core':
            continue
        queue, seen = [(library, [library.name])], {library.name}
        while queue:
            here, path = queue.pop()
            for target in here.others:
                if target in GRAPHICS_TARGETS:
                    yield f'{library.name} must do without {target}: ' + ' -> '.join(path + [target])
            for link in here.links:
                if link in tree.libraries and link not in seen:
                    seen.add(link)
                    queue.append((tree.libraries[link], path + [link]))


def problems(root):
    tree = Tree(root)
    return [problem for rule in (unlisted, crowded, unnamed_includes, idle_links, circles, graphics_includes,
                                 graphics_links) for problem in rule(tree)]
