"""The versions of a session, listed and drawn as a contact sheet; and in the report."""
import json

import numpy as np

import swaplight_cli as cli

MARGIN, GUTTER, TITLE = 32, 24, 60  # core/report/contact_sheet.cpp


class VersionsTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        cli.Capture(self.path('set'), height=60, width=80).save()
        self.succeed('solve', self.path('set', 'capture.json'), '-o', self.path('solved.exr'), '--model', 'transport',
                     '--float', '-q')
        rig = {'lights': [{'name': 'key', 'stops': -1}, {'name': 'fill'}]}
        scene = {'display': {'display': 'sRGB', 'view': 'ACES SDR', 'grade': {'slope': [1.2, 1, .9]}},
                 'edits': {'size': [80, 60], 'edits': [{'name': 'Brighter', 'lights': ['key'], 'meaning': 'add', 'operation': 'fill', 'value': .5}]}}
        self.looks = [{'name': 'Plain', 'rig': rig},
                      {'name': 'Morning', 'note': 'warm, the window is the key; ' * 9, 'rig': rig, 'scene': scene},
                      {'name': 'N\u00e4chste', 'note': 'kurz', 'rig': {'lights': [{'name': 'key', 'on': False}]}}]
        self.session = self.write(self.looks)

    def write(self, looks, name='show.swaplight'):
        with open(self.path(name), 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr', 'rig': {'lights': [{'name': 'key'}, {'name': 'fill'}]}} | ({'looks': looks} if looks else {}), file)
        return self.path(name)

    def tiles(self, sheet, columns, width=80, height=60):
        count = len(self.looks)
        rows = -(-count // columns)
        cell = (sheet.shape[0] - 2 * MARGIN - TITLE) // rows
        return [sheet[MARGIN + TITLE + i // columns * cell:][:height, MARGIN + i % columns * (width + GUTTER):][:, :width]
                for i in range(count)]

    def test_they_are_listed(self):
        listed = self.succeed_json('versions', self.session)['versions']
        self.assertEqual([(v['name'], v['kind']) for v in listed],
                         [('Plain', 'look'), ('Morning', 'version'), ('N\u00e4chste', 'look')])
        self.assertEqual(listed[2]['note'], 'kurz')

    def test_every_picture_of_the_sheet_is_the_frame_of_its_version(self):
        for columns in (1, 2, 3):
            self.succeed('versions', self.session, '-o', self.path('sheet.png'), '--columns', columns)
            for look, tile in zip(self.looks, self.tiles(cli.read_rgb(self.path('sheet.png')), columns)):
                self.succeed('relight', self.session, '--look', look['name'], '-o', self.path('frame.png'))
                np.testing.assert_allclose(tile, cli.read_rgb(self.path('frame.png')), atol=1.01 / 255,
                                           err_msg=f'{look["name"]} {columns}')

    def test_names_and_notes_are_written_below(self):
        sheet = self.path('sheet.png')
        self.succeed('versions', self.session, '-o', sheet, '--columns', 3)
        with_notes = cli.read_rgb(sheet)
        below = with_notes[MARGIN + TITLE + 60:]
        for i in range(3):
            caption = below[:, MARGIN + i * (80 + GUTTER):][:, :80]
            self.assertGreater(caption.max(), .5, 'the name')
        self.assertLess(np.abs(below[:, MARGIN + 80 + 2:MARGIN + 80 + GUTTER - 2] - 30 / 255).max(), .01, 'nothing runs over')
        for look in self.looks:
            look.pop('note', None)
        self.write(self.looks)
        self.succeed('versions', self.session, '-o', sheet, '--columns', 3)
        self.assertLess(len(cli.read_rgb(sheet)), len(with_notes), 'no room is kept for notes that nobody wrote')

    def test_they_serve_another_set_of_the_same_lights(self):
        cli.Capture(self.path('close'), names=('fill', 'key', 'lamp'), height=48, width=64).save()
        close = self.path('close.exr')
        self.succeed('solve', self.path('close', 'capture.json'), '-o', close, '--model', 'transport', '--float', '-q')
        edits = [{'name': 'Brighter', 'lights': ['key'], 'meaning': 'add', 'operation': 'fill', 'value': .5}]
        word = {'name': 'Word', 'lights': ['key'], 'meaning': 'add', 'operation': 'fill', 'value': 1,
                'mask': [{'shape': 'rectangle', 'x': 2, 'y': 2, 'width': 20, 'height': 20}]}
        self.looks[1]['scene']['edits']['edits'].append(word)
        self.looks[1]['rig']['lights'].append({'name': 'rim'})
        self.looks[1]['scene']['display'] = {}
        with open(self.path('edits.json'), 'w') as file:
            json.dump({'format': 'swaplight-edits', 'version': 1, 'edits': edits}, file)
        self.write(self.looks)
        result = self.succeed('relight', close, '--from', self.session, '--look', 'Morning', '-o', self.path('a.exr'))
        said = result.stderr
        for words in ('not in this set, left out: rim', 'only in this set, as captured: lamp',
                      'Morning: light edits of the other picture are left out: Word'):
            self.assertIn(words, said)
        self.succeed('relight', close, '--light', 'key=-1st', '--edits', self.path('edits.json'), '-o', self.path('b.exr'))
        frame = cli.read_rgb(self.path('a.exr'))
        self.assertEqual(frame.shape, (48, 64, 3))
        np.testing.assert_array_equal(frame, cli.read_rgb(self.path('b.exr')))
        self.succeed('relight', close, '--from', self.session, '--look', 'Plain', '-o', self.path('plain.exr'))
        self.succeed('relight', close, '--light', 'key=-1st', '-o', self.path('line.exr'))
        plain = cli.read_rgb(self.path('plain.exr'))
        np.testing.assert_array_equal(plain, cli.read_rgb(self.path('line.exr')))
        self.assertGreater(np.abs(frame - plain).mean(), .01, 'its edit is there')
        self.deny('relight', '--from', self.session, '-o', self.path('x.exr'), naming='give the other set as SOURCE')
        self.deny('relight', self.path('none.exr'), '--from', self.session, '-o', self.path('x.exr'), naming='no such file')

    def test_large_pictures_are_shrunk_in_light(self):
        self.succeed('versions', self.session, '-o', self.path('small.tif'), '--width', 64, '--columns', 3)
        self.assertEqual(cli.read_rgb(self.path('small.tif')).shape[1], 2 * MARGIN + 3 * 64 + 2 * GUTTER)

    def test_the_report_shows_them(self):
        self.succeed('report', self.session, '-o', self.path('report.html'))
        with open(self.path('report.html')) as file:
            page = file.read()
        self.assertIn('Versions', page)
        for look in self.looks:
            self.assertIn(look['name'], page)
            self.assertIn(look.get('note', '').strip()[:20], page)
        plain = self.write([], 'none.swaplight')
        self.succeed('report', plain, '-o', self.path('plain.html'))
        with open(self.path('plain.html')) as file:
            self.assertNotIn('Versions', file.read())

    def test_without_opengl_they_are_drawn_without_their_camera_looks_and_that_is_said(self):
        without = {'__EGL_VENDOR_LIBRARY_DIRS': '/nowhere'}
        self.succeed('versions', self.session, '-o', self.path('plain.png'))
        self.looks[1]['scene']['camera_look'] = {'format': 'swaplight-look', 'version': 1, 'name': 'Aged',
                                                   'filters': [{'filter': 'sepia'}]}
        self.write(self.looks)
        for verb, file in (('versions', 'sheet.png'), ('report', 'report.html')):
            result = cli.run(verb, self.session, '-o', self.path(file), env=without)
            self.assertEqual(result.returncode, 0, result.stderr)
            said = [line for line in result.stderr.splitlines() if 'Aged' in line]
            self.assertEqual(len(said), 1, result.stderr)
            self.assertIn('no OpenGL', said[0])
        np.testing.assert_array_equal(cli.read_rgb(self.path('sheet.png')), cli.read_rgb(self.path('plain.png')))
        self.succeed('versions', self.session, '-o', self.path('seen.png'))
        self.assertTrue((cli.read_rgb(self.path('seen.png')) != cli.read_rgb(self.path('plain.png'))).any())

    def test_bad_input_is_said_in_a_line(self):
        self.deny('versions', self.write([], 'none.swaplight'), '-o', self.path('x.png'), naming='gallery is empty')
        self.deny('versions', self.session, '-o', self.path('x.exr'), naming='.png, .jpg or .tif')
        self.deny('versions', self.session, '-o', self.path('solved.exr.png', 'x.png'), naming='solved.exr.png')
        self.deny('versions', self.path('no.swaplight'), naming='no.swaplight')
        self.deny('versions', self.session, '-o', self.path('x.png'), '--columns', 0, naming='--columns')


if __name__ == '__main__':
    cli.main()
