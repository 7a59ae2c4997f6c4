"""The grade of the finished frame: ASC CDL files read and written, in sessions, on frames."""
import json

import numpy as np

import cli

# Linear Rec.709 to ACEScg, white adapted by Bradford (ACES TB-2014-004, S-2014-004).
AP1_FROM_REC709 = np.array([[0.6131324224, 0.3395380158, 0.0474166960],
                            [0.0701243808, 0.9163940113, 0.0134515240],
                            [0.0205876575, 0.1095745716, 0.8697854040]])
LUMA = np.array([0.2126, 0.7152, 0.0722])
SLOPE, OFFSET, POWER, SATURATION = [1.1, 1, .93], [.01, -.004, .02], [.95, 1, 1.08], .8


def acescct(linear):
    """Academy S-2016-001, equation 5."""
    return np.where(linear > 0.0078125, (np.log2(np.maximum(linear, 1e-9)) + 9.72) / 17.52,
                    10.5402377416545 * linear + 0.0729055341958355)


def linear(code):
    return np.where(code > 0.155251141552511, 2 ** (code * 17.52 - 9.72), (code - 0.0729055341958355) / 10.5402377416545)


def graded(rec709):
    """The ASC CDL by its definition, in ACEScct."""
    code = acescct(rec709 @ AP1_FROM_REC709.T) * SLOPE + OFFSET
    code = np.where(code > 0, np.maximum(code, 0) ** POWER, code)
    luma = (code @ LUMA)[..., None]
    return linear(luma + SATURATION * (code - luma)) @ np.linalg.inv(AP1_FROM_REC709).T


def text(values):
    return '/'.join(map(str, values))


class GradeTest(cli.CliTest):
    def setUp(self):
        super().setUp()
        cli.Capture(self.path('set'), height=40, width=56).save()
        self.solved = self.path('solved.exr')
        self.succeed('solve', self.path('set', 'capture.json'), '-o', self.solved, '--model', 'transport', '--float', '-q')
        self.session = self.path('show.swaplight')
        with open(self.session, 'w') as file:
            json.dump({'format': 'swaplight-session', 'version': 1, 'source': 'solved.exr'}, file)
        self.cc = self.path('grade.cc')
        self.succeed('grade', self.session, '--slope', text(SLOPE), '--offset', text(OFFSET), '--power', text(POWER),
                     '--saturation', SATURATION, '-o', self.cc)

    def frame(self, *arguments, out='out.exr', source=None):
        self.succeed('relight', source or self.solved, '-o', self.path(out), *arguments,
                     *(['--type', 'float'] if out.endswith('.exr') else []))
        return cli.read_rgb(self.path(out))

    def test_a_frame_under_a_cdl_is_the_published_formula(self):
        plain, ours = self.frame(), self.frame('--cdl', self.cc)
        np.testing.assert_allclose(ours, graded(plain), atol=1e-4, rtol=1e-4)
        self.assertGreater(np.abs(ours - plain).max(), .02)

    def test_the_sessions_grade_is_on_its_frames_and_only_there_where_it_is_on(self):
        plain = self.frame()
        self.succeed('grade', self.session, '--from', self.cc)
        self.assertIn('grade', self.succeed('info', self.session).stdout)
        seen = self.frame(source=self.session)
        np.testing.assert_array_equal(seen, self.frame('--cdl', self.cc))
        np.testing.assert_array_equal(self.frame('--cdl', 'none', source=self.session), plain)
        self.succeed('grade', self.session, '--off')
        np.testing.assert_array_equal(self.frame(source=self.session), plain)
        self.succeed('grade', self.session, '--on')
        np.testing.assert_array_equal(self.frame(source=self.session), seen)

    def test_a_view_shows_the_graded_light(self):
        """The PNG of the graded session is the view of the graded EXR."""
        self.succeed('grade', self.session, '--from', self.cc)
        light = np.clip(self.frame(source=self.session), 0, None)
        codes = np.where(light <= .0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - .055)
        png = self.frame('--view', 'sRGB', '--display', 'sRGB', '--type', 'uint16', out='out.png', source=self.session)
        np.testing.assert_allclose(png, np.clip(codes, 0, 1), atol=3e-5)

    def test_sequences_and_tone_mapping_have_it(self):
        plain, ours = self.frame('--tone', 'drago', out='a.png'), self.frame('--tone', 'drago', '--cdl', self.cc, out='b.png')
        self.assertGreater(np.abs(plain - ours).max(), .01)
        still = self.frame('--cdl', self.cc)
        self.succeed('relight', self.solved, '-F', '1-2', '--cdl', self.cc, '-o', self.path('s.####.exr'), '--type', 'float')
        np.testing.assert_array_equal(cli.read_rgb(self.path('s.0002.exr')), still)

    def test_lift_gamma_and_gain_are_the_same_grade(self):
        result = self.succeed_json('grade', self.cc, '--reset', '--lift', .1, '--gamma', '1/2/1', '--gain', 1.5, '-o',
                                   self.path('b.cc'))
        np.testing.assert_allclose(result['slope'], [1.35] * 3)
        np.testing.assert_allclose(result['offset'], [.15] * 3)
        np.testing.assert_allclose(result['power'], [1, .5, 1])
        back = self.succeed_json('grade', self.path('b.cc'))
        np.testing.assert_allclose(back['lift'], [.1] * 3, atol=1e-6)
        np.testing.assert_allclose(back['gamma'], [1, 2, 1], atol=1e-6)
        np.testing.assert_allclose(back['gain'], [1.5] * 3, atol=1e-6)

    def test_files_of_all_three_kinds_and_their_ids(self):
        for name in ('a.cc', 'a.ccc', 'a.cdl'):
            self.succeed('grade', self.cc, '-o', self.path(name))
            back = self.succeed_json('grade', self.path(name))
            np.testing.assert_allclose(back['slope'], SLOPE, atol=1e-6)
        np.testing.assert_array_equal(self.frame('--cdl', self.path('a.ccc'), '--cdl-id', 'swaplight_grade'),
                                      self.frame('--cdl', self.cc))
        with open(self.cc) as file:
            self.assertIn('acescct', file.read())

    def test_a_collection_is_not_replaced_by_one_of_its_corrections(self):
        self.succeed('grade', self.cc, '-o', self.path('a.ccc'))
        with open(self.path('a.ccc')) as file:
            kept = file.read()
        self.deny('grade', self.path('a.ccc'), '--gain', 1.1, '-o', self.path('a.ccc'), naming='a.ccc')
        with open(self.path('a.ccc')) as file:
            self.assertEqual(file.read(), kept)

    def test_bad_input_is_said_in_a_line(self):
        for arguments, word in (
                (['relight', self.solved, '--cdl', self.path('no.cc'), '-o', self.path('x.exr')], 'no such file'),
                (['relight', self.solved, '--cdl', self.solved, '-o', self.path('x.exr')], '.cc, .ccc or .cdl'),
                (['relight', self.solved, '--cdl-id', 'a', '-o', self.path('x.exr')], '--cdl'),
                (['grade', self.cc, '--gain', 2], '-o FILE.cc'),
                (['grade', self.cc, '--gain', '1/2', '-o', self.path('x.cc')], '1.1/1/0.9'),
                (['grade', self.cc, '--slope', 99, '-o', self.path('x.cc')], 'slope is 99'),
                (['grade', self.cc, '--gamma', 0, '-o', self.path('x.cc')], '--gamma'),
                (['grade', self.cc, '-o', self.path('x.exr')], '.cdl'),
                (['grade', self.session, '--gain', 2, '-o', self.solved], 'solved.exr')):
            self.deny(*arguments, naming=word)


if __name__ == '__main__':
    cli.main()
