"""swaplight info"""
import json

import OpenImageIO as oiio

import swaplight_cli as cli


class InfoTest(cli.CliTest):
    def test_of_a_capture_lists_its_lights_and_shots(self):
        capture = cli.Capture(self.path('set'))
        capture.manifest['mood'] = 'blue'
        capture.save()
        for path in (capture.path, capture.folder):
            text = self.succeed('info', path).stdout
            for word in ('small', 'key', 'fill', 'shot_01.exr', '16 x 12', '0.900 0.200 0.150', 'mood'):
                self.assertIn(word, text)
        result = self.succeed_json('info', capture.path)
        self.assertEqual((result['kind'], result['width'], result['height']), ('capture', 16, 12))
        self.assertEqual(result['capture']['mood'], 'blue')
        self.assertEqual(len(result['capture']['shots']), 2)
        self.assertIn('mood', result['warnings'][0])

    def test_of_a_solved_set_lists_its_lights_and_how_it_was_solved(self):
        capture = cli.Capture(self.path('set'))
        solved = self.path('solved.exr')
        self.succeed('solve', capture.path, '-o', solved, '-q')
        text = self.succeed('info', solved).stdout
        for word in ('solved set', 'key', 'fill', '16 x 12', 'quality.sigma'):
            self.assertIn(word, text)
        result = self.succeed_json('info', solved)
        self.assertEqual(result['kind'], 'solved')
        self.assertEqual([light['name'] for light in result['capture']['lights']], ['key', 'fill'])
        self.assertIn('message', result['report'])

    def test_the_range_of_each_light_is_that_of_the_pixels(self):
        capture = cli.Capture(self.path('set'))
        solved, bare = self.path('solved.exr'), self.path('bare.exr')
        self.succeed('solve', capture.path, '-o', solved, '-q', '--float')
        said = self.succeed_json('info', solved)['dynamic_range']
        self.assertEqual([light['light'] for light in said], ['key', 'fill'])
        source = oiio.ImageBuf(solved)  # as a solved set without it in the header
        source.specmod().erase_attribute('swaplight/dynamicRange')
        self.assertTrue(source.write(bare))
        for a, b in zip(said, self.succeed_json('info', bare)['dynamic_range']):
            self.assertAlmostEqual(a['stops'], b['stops'], places=3)
        # The header is enough: most of the pixels may be missing.
        with open(solved, 'rb') as file, open(self.path('head.exr'), 'wb') as head:
            data = file.read()
            head.write(data[:int(len(data) * .7)])
        self.assertEqual(self.succeed_json('info', self.path('head.exr'))['dynamic_range'], said)

    def test_of_a_session_and_a_rig_lists_the_settings(self):
        session, rig = self.path('a.swaplight'), self.path('rig.json')
        lights = {'format': 'swaplight-rig', 'lights': [{'name': 'key', 'color': '3200K', 'stops': 1, 'solo': True}]}
        with open(session, 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'set/capture.json', 'rig': lights}, file)
        with open(rig, 'w') as file:
            json.dump(lights, file)
        for path, kind in ((session, 'session'), (rig, 'rig')):
            text = self.succeed('info', path).stdout
            for word in (kind, 'key', '3200K,+1st', 'solo'):
                self.assertIn(word, text)
            self.assertEqual(self.succeed_json('info', path)['kind'], kind)

    def test_of_a_picture_says_its_size_and_channels(self):
        for name, pixel_type in (('a.exr', 'half'), ('b.png', 'uint16'), ('c.jpg', 'uint8'), ('d.tif', 'uint8')):
            cli.write_image(self.path(name), cli.contributions(1)[0], pixel_type)
            result = self.succeed_json('info', self.path(name))
            self.assertEqual((result['kind'], result['width'], result['height']), ('image', 16, 12))
            self.assertEqual(result['channels'], ['R', 'G', 'B'])
            self.assertEqual(result['pixel_type'], pixel_type)
            self.assertIn('16 x 12', self.succeed('info', self.path(name)).stdout)

    def test_bad_input_is_one_line(self):
        self.deny('info', self.path('none.exr'), naming='none.exr')
        self.deny('info', self.folder, naming='capture.json')
        with open(self.path('a.txt'), 'w') as file:
            file.write('hello')
        self.deny('info', self.path('a.txt'), naming='a.txt')
        with open(self.path('a.json'), 'w') as file:
            file.write('{"lights": [}')
        self.deny('info', self.path('a.json'), naming=['a.json', 'line 1', 'column'])


if __name__ == '__main__':
    cli.main()
