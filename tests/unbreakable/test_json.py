"""Small JSON never takes long: lists and objects have a largest size, and what is read is read in one go."""
import json
import resource

import cli

SESSION = {'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr'}


class SmallJsonTest(cli.CliTest):
    def write(self, name, value):
        with open(self.path(name), 'w') as file:
            json.dump(value, file)
        return self.path(name)

    def assert_quick(self, verb, value, seconds=3, name='a.swaplight', **options):
        """Refused or read, within seconds of processor time on a machine that may be busy."""
        path = self.write(name, value)
        used = lambda: resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        begun = used()
        if options:
            self.deny(verb, path, **options)
        else:
            self.succeed(verb, path)
        self.assertLess(used() - begun, seconds)

    def test_looks(self):
        looks = [{'rig': {'lights': []}}]
        self.assert_quick('info', {**SESSION, 'looks': looks * 256})
        self.assert_quick('info', {**SESSION, 'looks': looks * 3000}, naming=['a.swaplight', '256'])

    def test_keys(self):
        self.assert_quick('info', {**SESSION, **{f'k{i}': 0 for i in range(4000)}})
        self.assert_quick('info', {f'k{i}': 0 for i in range(200000)}, naming=['a.swaplight', '4096 keys'])
        deep = {'a': [{f'k{i}': {f'l{j}': 0 for j in range(5000 * (i == 3))} for i in range(5)}]}
        self.assert_quick('info', deep, naming='4096 keys')

    def test_lights(self):
        rig = lambda count: {**SESSION, 'rig': {'lights': [{'name': f'l{i}', 'mine': 1} for i in range(count)]}}
        self.assert_quick('info', rig(64))
        self.assert_quick('info', rig(60000), naming=['a.swaplight', 'at most 64'])
        capture = {'format': 'swaplight-capture', 'version': 1, 'lights': [{'name': f'l{i}'} for i in range(100000)],
                   'shots': []}
        self.assert_quick('info', capture, name='capture.json', naming='at most 64')

    def test_shots(self):
        capture = {'format': 'swaplight-capture', 'version': 1, 'lights': [{'name': 'key'}],
                   'shots': [{'image': 'a.exr', 'light_colors': [[1, 1, 1]]}] * 10000}
        self.assert_quick('info', capture, name='capture.json', naming='at most 4096')

    def test_strokes(self):
        stroke = {'radius': 4, 'points': [[i % 30, i % 20, 1] for i in range(100000)]}
        edits = {'size': [32, 24], 'edits': [{'lights': ['key'], 'operation': 'fill', 'mask': [
            {'shape': 'painted', 'strokes': [stroke]}]}]}
        self.assert_quick('info', {**SESSION, 'edits': edits}, seconds=3)

    def test_a_stroke_with_a_far_point(self):
        for point in ([1e9, 0], [1e300, 0], [0, -1e7]):
            edits = {'size': [32, 24], 'edits': [{'lights': ['key'], 'operation': 'fill', 'mask': [
                {'shape': 'painted', 'strokes': [{'radius': 4, 'points': [[0, 0], point]}]}]}]}
            self.assert_quick('info', {**SESSION, 'edits': edits}, naming=['a.swaplight', 'a point has'])

    def test_values_and_bytes(self):
        with open(self.path('many.json'), 'w') as file:
            file.write('[' + '[],' * 9_000_000 + '[]]')
        self.deny('info', self.path('many.json'), naming=['many.json', 'values'])
        with open(self.path('long.json'), 'w') as file:
            file.truncate(65 << 20)
        self.deny('info', self.path('long.json'), naming=['long.json', '64 MiB'])

    def test_a_number_of_100000_digits(self):
        with open(self.path('digits.json'), 'w') as file:
            file.write('{"a": ' + '9' * 100000 + '}')
        self.assertLess(len(self.deny('info', self.path('digits.json'), naming='too large')), 500)


if __name__ == '__main__':
    cli.main()
