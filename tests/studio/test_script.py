"""Scripts in a real window."""
import os
import unittest

from studio_session import SAMPLES, Studio, StudioTest, read_png


class Scripts(StudioTest):
    def ended_script(self, *lines):
        script = os.path.join(self.folder, 'script.txt')
        with open(script, 'w') as file:
            file.write('\n'.join(lines) + '\n')
        studio = Studio(self.display, self.folder, '--script', script)
        errors = studio.process.communicate(timeout=120)[1]
        return studio.process.returncode, errors

    def run_script(self, *lines):
        code, errors = self.ended_script(*lines)
        self.assertEqual(code, 0, errors)

    def test_a_line_that_is_wrong_is_named(self):
        for line, words in (('frames x', 'frames: "x" is no number from 0 to 1000000'),
                            ('sleep -1', 'sleep: "-1" is no number from 0 to 3600'),
                            ('hover file.menu 1', 'hover: write X Y from 0 to 1')):
            code, errors = self.ended_script('# a comment', line)
            self.assertEqual(code, 2, errors)
            self.assertIn('script.txt, line 2: ' + words, errors)

    def test_a_screenshot_may_be_the_first_thing_that_a_script_does(self):
        picture = os.path.join(self.folder, 'first.png')
        self.run_script('screenshot ' + picture, 'quit')
        self.assertEqual(read_png(picture).shape, (720, 1280, 3))

    def test_a_screenshot_shows_what_the_lines_before_it_did(self):
        before, after = os.path.join(self.folder, 'before.png'), os.path.join(self.folder, 'after.png')
        self.run_script('open ' + os.path.join(SAMPLES, 'three_point/capture.json'), 'wait', 'screenshot ' + before,
                        'action mixer.all_off', 'wait', 'screenshot ' + after, 'quit')
        viewer = lambda file: read_png(file)[200:500, 300:800].mean()
        self.assertGreater(viewer(before), viewer(after) + 5)


if __name__ == '__main__':
    unittest.main()
