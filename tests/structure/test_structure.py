"""The tree keeps its architecture (structure.py), and the rules do refuse what they are for."""
import pathlib
import tempfile
import unittest

import structure

ROOT = pathlib.Path(__file__).resolve().parents[2]


def library(name, sources, link='', more=''):
    return f'swaplight_library({name}\n  SOURCES {sources}\n  LINK {link}\n  {more})\n'


class ProjectTest(unittest.TestCase):
    def test_the_project_has_libraries_and_sources_to_look_at(self):
        tree = structure.Tree(ROOT)
        self.assertGreater(len(tree.libraries), 40)
        self.assertGreater(len(tree.files), 500)
        self.assertGreater(sum(map(len, structure.arrows(tree).values())), 150)

    def test_the_project_keeps_the_rules(self):
        found = structure.problems(ROOT)
        self.assertFalse(found, '\n' + '\n'.join(found))


class PlantedTest(unittest.TestCase):
    """A small tree that is right, and each way to make it wrong."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.plant('core/base/CMakeLists.txt', library('swaplight_base', 'error.cpp error.h'))
        self.plant('core/base/error.h', '#pragma once\n#include <string>\n')
        self.plant('core/base/error.cpp', '#include "core/base/error.h"\n')
        self.plant('core/set/CMakeLists.txt', library('swaplight_set', 'set.h set.cpp', 'swaplight_base'))
        self.plant('core/set/set.h', '#pragma once\n')
        self.plant('core/set/set.cpp', '#include "core/set/set.h"\n\n#include "core/base/error.h"\n')
        self.plant('render/CMakeLists.txt', library('swaplight_render', 'gl.h', 'swaplight_base'))
        self.plant('render/gl.h', '#include <epoxy/gl.h>\n#include "core/base/error.h"\n')
        self.plant('ui/kit/CMakeLists.txt', library('swaplight_ui_kit', 'kit.h', '', 'PUBLIC PkgConfig::IMGUI'))
        self.plant('ui/kit/kit.h', '#include <imgui.h>\n')
        self.plant('ui/control/CMakeLists.txt', library('swaplight_ui_control', 'control.h', 'swaplight_set'))
        self.plant('ui/control/control.h', '#include "core/set/set.h"\n')
        self.plant('app/CMakeLists.txt', '# swaplight_library(no such)\nadd_executable(swaplight main.cpp)\n'
                   'target_link_libraries(swaplight PRIVATE swaplight_set)\n')
        self.plant('app/main.cpp', '#include "core/set/set.h"\n')

    def plant(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def append(self, name, text):
        self.plant(name, (self.root / name).read_text() + text)

    def refused(self, *words):
        """One problem at least, and one of them with all the words."""
        found = structure.problems(self.root)
        self.assertTrue([line for line in found if all(word in line for word in words)], (words, found))
        return found

    def test_a_right_tree_is_not_refused(self):
        self.assertEqual(structure.problems(self.root), [])

    def test_a_circle_is_refused_and_its_arrows_named(self):
        self.append('core/base/error.h', '#include "core/set/set.h"\n')
        self.plant('core/base/CMakeLists.txt', library('swaplight_base', 'error.cpp error.h', 'swaplight_set'))
        found = self.refused('circle', 'core/base -> core/set -> core/base',
                             'core/base/error.h:3 includes core/set/set.h',
                             'core/set/set.cpp:3 includes core/base/error.h')
        self.assertEqual(len(found), 1, 'a circle is told once')

    def test_a_circle_over_three_folders_is_refused(self):
        self.plant('core/lamp/CMakeLists.txt', library('swaplight_lamp', 'lamp.h', 'swaplight_set'))
        self.plant('core/lamp/lamp.h', '#include "core/set/set.h"\n')
        self.append('core/base/error.cpp', '#include "core/lamp/lamp.h"\n')
        self.refused('circle', 'core/base -> core/lamp -> core/set -> core/base')

    def test_an_include_that_the_link_line_does_not_name_is_refused(self):
        self.plant('core/set/CMakeLists.txt', library('swaplight_set', 'set.h set.cpp'))
        self.refused('core/set/set.cpp:3', 'core/base/error.h', 'swaplight_base', 'core/set/CMakeLists.txt')

    def test_an_include_over_another_library_is_refused(self):
        self.append('ui/control/control.h', '#include "core/base/error.h"\n')
        self.refused('ui/control/control.h:2', 'swaplight_base')

    def test_a_link_that_nothing_uses_is_refused(self):
        self.plant('ui/control/CMakeLists.txt',
                   library('swaplight_ui_control', 'control.h', 'swaplight_base swaplight_set'))
        self.refused('swaplight_ui_control names swaplight_base')

    def test_the_program_has_a_link_line_too(self):
        self.append('app/main.cpp', '#include "core/base/error.h"\n')
        self.refused('app/main.cpp:2', 'swaplight_base')

    def test_an_upper_layer_is_refused(self):
        self.plant('core/set/CMakeLists.txt',
                   library('swaplight_set', 'set.h set.cpp', 'swaplight_base swaplight_ui_kit'))
        self.append('core/set/set.cpp', '#include "ui/kit/kit.h"\n')
        self.refused('core/set/set.cpp:4', 'core must not know ui')

    def test_a_source_that_nobody_lists_is_refused(self):
        self.plant('core/set/forgotten.cpp', '')
        self.refused('core/set/forgotten.cpp', 'no CMakeLists.txt lists it')

    def test_a_listed_source_that_is_not_there_is_refused(self):
        (self.root / 'core/base/error.cpp').unlink()
        self.refused('core/base/error.cpp', 'no such file')

    def test_an_include_of_a_file_that_is_not_there_is_refused(self):
        self.append('core/set/set.cpp', '#include "core/base/gone.h"\n')
        self.refused('core/set/set.cpp:4', 'core/base/gone.h', 'no such file')

    def test_a_relative_include_is_refused(self):
        self.append('core/set/set.cpp', '#include "set.h"\n')
        self.refused('core/set/set.cpp:4', 'from the project\'s root')

    def test_graphics_are_refused_where_they_do_not_belong(self):
        for file, include, what in (('core/set/set.cpp', '<imgui.h>', 'Dear ImGui'),
                                    ('core/set/set.h', '<epoxy/gl.h>', 'OpenGL'),
                                    ('render/gl.h', '<imgui.h>', 'Dear ImGui'),
                                    ('render/gl.h', '<GLFW/glfw3.h>', 'GLFW'),
                                    ('ui/control/control.h', '<imgui_stdlib.h>', 'Dear ImGui'),
                                    ('ui/kit/kit.h', '<epoxy/gl.h>', 'OpenGL'),
                                    ('ui/kit/kit.h', '<GLFW/glfw3.h>', 'GLFW'),
                                    ('app/main.cpp', '<imgui.h>', 'Dear ImGui')):
            with self.subTest(file=file, include=include):
                before = (self.root / file).read_text()
                self.append(file, f'#include {include}\n')
                self.refused(file, what)
                self.plant(file, before)

    def test_graphics_that_come_through_another_library_are_refused(self):
        self.plant('ui/control/CMakeLists.txt',
                   library('swaplight_ui_control', 'control.h', 'swaplight_set swaplight_ui_kit'))
        self.append('ui/control/control.h', '#include "ui/kit/kit.h"\n')
        self.refused('swaplight_ui_control', 'swaplight_ui_kit', 'PkgConfig::IMGUI')

    def test_a_crowded_folder_is_refused(self):
        names = [f'part{i}.h' for i in range(structure.MOST_FILES)]
        for name in names:
            self.plant(f'core/big/{name}', '')
        self.plant('core/big/CMakeLists.txt', library('swaplight_big', ' '.join(names)))
        self.refused('core/big', str(structure.MOST_FILES + 1))

    def test_so_is_one_of_tests_but_not_one_of_pictures(self):
        for i in range(structure.MOST_FILES + 1):
            self.plant(f'tests/data/{i}.png', '')
            self.plant(f'tests/cli/test_{i}.py', '')
        self.refused('tests/cli', str(structure.MOST_FILES + 1))
        self.assertFalse([problem for problem in structure.problems(self.root) if 'tests/data' in problem])


if __name__ == '__main__':
    unittest.main()
