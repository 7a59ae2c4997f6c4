"""swaplight chart: light and camera off a Macbeth chart, gels into a table, colours of a capture."""
import csv
import json

import numpy as np
import cli
from camera_raw import write_dng
from made_chart import CORNERS, photograph


def to_srgb(light):
    light = np.clip(light, 0, 1)
    return np.where(light > .0031308, 1.055 * light ** (1 / 2.4) - .055, 12.92 * light)


LAMP, GEL = np.array([.8, .7, .6]), np.array([.75, .35, .2])


class Chart(cli.CliTest):
    def photo(self, name, light, **options):
        cli.write_image(self.path(name), photograph(light, **options))
        return self.path(name)

    def test_light_and_camera_are_read_off_the_chart(self):
        camera = np.array([[.78, .17, .05], [.12, .80, .08], [.03, .22, .75]])
        photo = self.photo('a.exr', LAMP, camera=camera)
        said = self.succeed_json('chart', photo, '-o', self.path('camera.json'))
        shot = said['shots'][0]
        np.testing.assert_allclose(shot['light'], LAMP, rtol=.01)
        self.assertLess(shot['delta_e']['mean'], 1)
        self.assertGreater(shot['delta_e']['balanced'], shot['delta_e']['mean'] + 2)
        np.testing.assert_allclose(np.array(said['camera_matrix']) @ camera, np.eye(3), atol=.03)
        self.assertTrue(shot['found'])
        self.assertLess(np.abs(np.array(shot['corners']) - CORNERS).max(), 12)
        with open(self.path('camera.json')) as file:
            self.assertEqual(json.load(file)['camera_matrix'], said['camera_matrix'])
        # What balance makes of it: the chart's own colours.
        out = self.path('out.exr')
        self.succeed('balance', photo, '--grey', '150,350', '--camera', self.path('camera.json'), '-o', out, '-q')
        plain, seen = photograph(np.ones(3), noise=0), cli.read_rgb(out)
        scale = np.median(seen[340:360, 140:160] / plain[340:360, 140:160])
        np.testing.assert_allclose(seen[110:120, 140:160].mean((0, 1)), scale * plain[115, 150], rtol=.05)

    def test_a_chart_in_the_picture_balances_it_at_once(self):
        camera = np.array([[.78, .17, .05], [.12, .80, .08], [.03, .22, .75]])
        photo = self.photo('a.exr', LAMP, camera=camera)
        said = self.succeed_json('balance', photo, '--chart', '-o', self.path('out.exr'))
        np.testing.assert_allclose(said['chart']['light'], LAMP, rtol=.01)
        self.assertLess(said['chart']['delta_e']['mean'], 1)
        plain, seen = photograph(np.ones(3), noise=0), cli.read_rgb(self.path('out.exr'))
        scale = np.median(seen[340:360, 140:160] / plain[340:360, 140:160])
        np.testing.assert_allclose(seen[110:120, 140:160].mean((0, 1)), scale * plain[115, 150], rtol=.05)
        # Without one it is said, and nothing is written.
        cli.write_image(self.path('grey.exr'), np.full((80, 100, 3), .3, np.float32))
        self.deny('balance', self.path('grey.exr'), '--chart', '-o', self.path('none.exr'), '-q',
                  naming=['grey.exr', 'no chart found', '--grey'])
        self.assertFalse(cli.os.path.exists(self.path('none.exr')))
        self.deny('balance', photo, '--chart', '--grey', '150,350', '-o', self.path('none.exr'), naming='--chart')

    def test_gels_are_measured_into_a_table(self):
        lamp, gel = self.photo('lamp.exr', LAMP), self.photo('gel.exr', LAMP * GEL)
        table = self.path('gels.csv')
        arguments = ['--without', lamp, '--gel', 'House,7,"Dusk, warm"', '--gels', table]
        said = self.succeed_json('chart', gel, *arguments)['gels'][0]
        self.assertEqual(said['id'], 'H7')
        np.testing.assert_allclose(said['filter'], GEL, rtol=.03, atol=.01)
        self.assertAlmostEqual(said['transmission'], GEL @ (.2126, .7152, .0722), 2)
        with open(table, newline='') as file:
            row = list(csv.DictReader(file))[0]
        self.assertEqual((row['name'], row['source']), ('Dusk, warm', 'measured'))
        self.deny('chart', gel, *arguments, '-q', naming=['gels.csv', 'H7'])
        self.deny('chart', gel, '--gels', table, naming='--without')
        self.deny('chart', gel, gel, *arguments, naming='2 photographs')
        self.deny('chart', gel, '--without', lamp, '--gel', 'House', '--gels', table, '-q', naming='House')
        # It is one of the gels from then on.
        data = self.path('data')
        with open(table) as file:
            text = file.read()
        cli.os.makedirs(cli.os.path.join(data, 'swaplight'))
        with open(cli.os.path.join(data, 'swaplight', 'gels.csv'), 'w') as file:
            file.write(text)
        result = cli.run('plan', '--lights', '2', '--gels', 'H7,L119', '--json', env={'XDG_DATA_HOME': data})
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_charts_give_the_colours_of_a_capture(self):
        colors = np.array([[.8, .2, .15], [.12, .3, .75]])
        capture = cli.Capture(self.path('made'), height=60, width=80,
                              light_colors=[colors.tolist(), colors[::-1].tolist()])
        for k, shot in enumerate(capture.shots):
            cli.write_image(self.path('shots', f'{k}.exr'), shot)
        for name, color in zip(('red', 'blue'), colors):
            self.photo(f'shots/chart_{name}.exr', color)
        said = self.succeed_json('new', self.path('shots'), '--lights', 'key,fill',
                                 '--colors', 'chart:chart_red.exr,chart:chart_blue.exr')
        self.assertEqual(len(said['shots']), 2, 'charts are no shots')
        with open(self.path('shots', 'capture.json')) as file:
            told = [shot['light_colors'] for shot in json.load(file)['shots']]
        np.testing.assert_allclose(told, [colors, colors[::-1]], rtol=.05, atol=.01)
        self.deny('new', self.path('shots'), '--lights', 'key,fill', '--colors', 'chart:none.exr,1/1/1', '--force',
                  naming='none.exr')

    def photographs(self, suffix, coded=lambda shot: shot, pixel_type='float', **attributes):
        """Photographs of a set under two lamps, and the lamps' colours."""
        colors = np.array([[.8, .2, .15], [.12, .3, .75]])
        capture = cli.Capture(self.path('made'), height=60, width=80,
                              light_colors=[colors.tolist(), colors[::-1].tolist()])
        for k, shot in enumerate(capture.shots):
            cli.write_image(self.path('shots', f'{k}.{suffix}'), coded(shot), pixel_type, **attributes)
        return colors

    def new(self, *charts):
        told = ','.join('chart:' + chart for chart in charts)
        return self.succeed_json('new', self.path('shots'), '--lights', 'key,fill', '--colors', told, '--force')

    def told(self):
        with open(self.path('shots', 'capture.json')) as file:
            return json.load(file)['shots'][0]['light_colors']

    def test_charts_are_decoded_as_what_they_are(self):
        """Whatever kind of file the photographs of the set are."""
        colors = self.photographs('exr')
        for name, color in zip(('red', 'blue'), colors):
            cli.write_image(self.path('shots', f'chart_{name}.png'), to_srgb(photograph(color)), 'uint16')
        self.new('chart_red.png', 'chart_blue.png')
        np.testing.assert_allclose(self.told(), colors, rtol=.05, atol=.01)
        for k in range(2):
            shot = cli.read_rgb(self.path('shots', f'{k}.exr'))
            cli.os.remove(self.path('shots', f'{k}.exr'))
            cli.write_image(self.path('shots', f'{k}.png'), to_srgb(shot), 'uint16')
        for name, color in zip(('red', 'blue'), colors):
            self.photo(f'shots/chart_{name}.exr', color)
        self.new('chart_red.exr', 'chart_blue.exr')
        np.testing.assert_allclose(self.told(), colors, rtol=.05, atol=.01)

    def test_exposures_that_charts_state_are_taken_off(self):
        colors = self.photographs('exr')
        exposed = lambda seconds: {'ExposureTime': seconds, 'FNumber': 4., 'Exif:ISOSpeedRatings': 100}
        cli.write_image(self.path('shots', 'chart_red.exr'), photograph(colors[0]), **exposed(1 / 8))
        cli.write_image(self.path('shots', 'chart_blue.exr'), photograph(colors[1]), **exposed(1 / 32))
        self.new('chart_red.exr', 'chart_blue.exr')
        np.testing.assert_allclose(self.told(), colors * [[1], [4]], rtol=.05, atol=.01)
        self.photo('shots/chart_mute.exr', colors[1])
        self.deny('new', self.path('shots'), '--lights', 'key,fill', '--colors',
                  'chart:chart_red.exr,chart:chart_mute.exr', '--force', '-q', naming=['chart_red.exr', 'chart_mute.exr'])

    def test_charts_that_are_no_shots_are_named(self):
        self.photographs('exr')
        for name in ('red', 'blue'):
            self.photo(f'shots/chart_{name}.exr', LAMP)
        write_dng(self.path('shots', 'chart_white.dng'), photograph(LAMP))
        cli.write_image(self.path('shots', 'chart_white.jpg'), to_srgb(photograph(LAMP)), 'uint8')
        said = self.new('chart_red.exr', 'chart_blue.exr')
        for name, why in (('red.exr', 'colour chart'), ('white.dng', 'colour chart'), ('white.jpg', 'its raw file')):
            self.assertTrue(any(f'chart_{name}' in text and why in text for text in said['warnings']), said['warnings'])
        for suffix in ('dng', 'jpg'):
            cli.os.remove(self.path('shots', f'chart_white.{suffix}'))
        for k in range(2):
            cli.os.remove(self.path('shots', f'{k}.exr'))
        said = self.succeed_json('new', self.path('shots'), '--lights', 'key,fill', '--one-at-a-time', '--force')
        self.assertEqual(len(said['shots']), 2, 'a set may be called so')

    def test_what_would_spoil_the_table_is_refused(self):
        lamp, gel = self.photo('lamp.exr', LAMP), self.photo('gel.exr', LAMP * GEL)
        table = self.path('gels.csv')
        into = ['--gel', 'House,7', '--gels', table]
        self.deny('chart', gel, '--without', lamp, *into, '-o', table, naming=['gels.csv', '--output'])
        self.deny('chart', lamp, '--without', gel, *into, '-q', naming=['H7', 'without it'])
        self.deny('chart', lamp, '--without', lamp, *into, naming=['lamp.exr', '--without'])
        self.succeed('chart', gel, '--without', lamp, *into)
        self.deny('chart', gel, '--without', lamp, '--gel', 'House,8', '--gels', table, '-o',
                  cli.os.path.join(self.path('.'), 'gels.csv'), naming='gels.csv')
        # Deep red light, of which no matrix can be told: the table stays as it is.
        red = [self.photo(f'red{k}.exr', np.array([.8, .05, .004]) * share, noise=0) for k, share in enumerate((1, .5))]
        into = ['--gel', 'House,9', '--gels', table, '-o', self.path('camera.json')]
        self.deny('chart', red[1], '--without', red[0], *into, '-q', naming='no camera matrix')

    def test_a_chart_that_is_not_found_is_where_another_has_it(self):
        lamp, hidden = self.photo('lamp.exr', LAMP), self.path('hidden.exr')
        pixels = photograph(LAMP)
        pixels[:, 250:420] = .3  # someone stands before it
        cli.write_image(hidden, pixels)
        said = self.succeed_json('chart', lamp, hidden)['shots'][1]
        self.assertFalse(said['found'])
        self.assertTrue(any('lamp.exr' in text for text in said['warnings']), said['warnings'])
        self.assertIn('as in lamp.exr', self.succeed('chart', lamp, hidden).stdout)

    def test_what_cannot_be_done_is_said_in_one_line(self):
        wall = self.path('wall.exr')
        cli.write_image(wall, np.full((300, 400, 3), .3))
        self.deny('chart', wall, '-q', naming=['wall.exr', 'no chart found', '--corners'])
        self.deny('chart', wall, '--corners', '1,2,3', naming=['--corners', 'X,Y,X,Y'])
        self.deny('chart', wall, '--corners', '10,10,90,10,90,70,10,70', '-q', naming=['wall.exr', 'does not look like'])
        self.deny('chart', self.path('none.exr'), naming='none.exr')
        photo = self.photo('bright.exr', LAMP * 4)
        corners = ','.join(f'{x},{y}' for x, y in CORNERS)
        self.succeed('chart', photo, '--corners', corners)  # floating point does not clip
        self.deny('chart', photo, '-o', photo, naming='bright.exr')
        self.deny('balance', photo, '--camera', photo, '-o', self.path('x.exr'), naming='bright.exr')
        with open(self.path('camera.json'), 'w') as file:
            json.dump({'format': 'swaplight-camera', 'version': 1, 'camera_matrix': [[1, 0, 0], [0, 2, 0], [0, 0, 1]]}, file)
        self.deny('balance', photo, '--camera', self.path('camera.json'), '-o', self.path('x.exr'), naming=['camera.json', 'white'])


if __name__ == '__main__':
    cli.main()
