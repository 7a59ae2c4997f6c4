"""swaplight report"""
import os
import shutil
import subprocess
import sys

import numpy as np
import swaplight_cli as cli


class ReportTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.capture = cli.Capture(self.path('set'), names=('key', 'fill', 'back'), height=48, width=64)
        self.capture.manifest['name'] = 'Kitchen <night> & "day"'
        self.capture.save()
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.capture.path, '-o', self.solved, '-q')
        self.page = self.path('report.html')

    def report(self, *arguments):
        result = self.succeed_json('report', self.solved, '-o', self.page, *arguments)
        with open(self.page, encoding='utf-8') as file:
            return result, file.read()

    def test_the_page_is_complete_in_itself_and_the_same_each_time(self):
        result, page = self.report('--light', 'key=3200K,gel:L201,+1.5st', '--light', 'back=off')
        for text in ('Kitchen &lt;night&gt; &amp;', 'gel:L201', '+1.50', 'L201', ' K, Duv', '>off<', 'residual',
                     'base64,', '@media print'):
            self.assertIn(text, page)
        for text in ('http:', 'https:', 'src="/', '<script', '<link'):
            self.assertNotIn(text, page)
        self.assertEqual(page.count('<figure>'), page.count('</figure>'))
        self.assertEqual(page.count('<figure>'), 5)
        self.assertEqual(page, self.report('--light', 'key=3200K,gel:L201,+1.5st', '--light', 'back=off')[1])
        self.assertEqual([r['light'] for r in result['dynamic_range']], ['key', 'fill', 'back'])

    def test_dynamic_range_is_smaller_where_there_is_more_noise(self):
        stops = []
        for noise in (.001, .01):
            self.capture.manifest['noise'] = {'read': noise, 'full_well': 1e7}  # read noise counts
            random = np.random.default_rng(5)
            shots = list(self.capture.shots)
            self.capture.shots = [s + random.normal(0, noise, s.shape).astype(np.float32) for s in shots]
            self.capture.save()
            self.capture.shots = shots
            self.succeed('solve', self.capture.path, '-o', self.solved, '-q')
            stops.append([r['stops'] for r in self.report()[0]['dynamic_range']])
        for quiet, loud in zip(*stops):
            self.assertGreater(quiet, loud + 2)

    def test_histograms_show_what_a_stop_does(self):
        result, _ = self.report('--histogram', self.path('h.png'), *[f'--light={n}=+3st' for n in ('key', 'fill', 'back')])
        after, before = result['luminance']['after'], result['luminance']['before']
        self.assertAlmostEqual(after['median_stops'] - before['median_stops'], 3, places=3)
        self.assertEqual(cli.read_rgb(self.path('h.png')).shape, (420, 1000, 3))

    def test_ten_stops_up_keep_the_hue_and_clip_nothing(self):
        solved = self.path('float.exr')
        self.succeed('solve', self.capture.path, '-o', solved, '--model', 'transport', '--float', '-q')
        frame = self.path('bright.exr')
        self.succeed('relight', solved, '--light', 'key=rgb:1/0.6/0.3,+10st', '--light', 'fill=-10st', '-o', frame)
        exact = self.capture.truth[0] * [1, .6, .3] * 1024 + self.capture.truth[1] / 1024 + self.capture.truth[2]
        found = cli.read_rgb(frame)
        self.assertGreater(found.max(), 50)
        np.testing.assert_allclose(found, exact, rtol=3e-3)

    def test_bad_input_is_one_line(self):
        self.deny('report', self.path('none.exr'), '-o', self.page, naming='none.exr')
        self.deny('report', self.solved, '--light', 'rim=off', '-o', self.page, naming='rim')
        self.deny('report', self.solved, '-o', self.path('no/such.html'), naming='such.html')

    def test_chromium_opens_and_prints_it(self):
        chromium = shutil.which('chromium')
        if not chromium:
            print('SKIPPED: chromium is not installed (apt install chromium)', file=sys.stderr)
            self.skipTest('chromium is not installed')
        self.report()
        base = [chromium, '--headless', '--no-sandbox', '--disable-gpu', f'--user-data-dir={self.path("profile")}']
        for arguments, made in ((['--window-size=1280,2000', f'--screenshot={self.path("desk.png")}'], 'desk.png'),
                                ([f'--print-to-pdf={self.path("page.pdf")}', '--no-pdf-header-footer'], 'page.pdf')):
            subprocess.run([*base, *arguments, 'file://' + self.page], capture_output=True, timeout=120)
            self.assertGreater(os.path.getsize(self.path(made)), 10000)
        self.assertGreater(np.std(cli.read_rgb(self.path('desk.png'))), .05)


if __name__ == '__main__':
    cli.main()
