"""swaplight plan: the colours, the table, the JSON, and what it says of bad plans."""
import math

import cli

PAPER = ','.join('#%02x%02x%02x' % code for code in ((218, 131, 102), (42, 165, 95), (255, 203, 0), (0, 38, 96)))


class PlanTest(cli.CliTest):
    def test_a_plan_is_a_table_of_colours_by_name(self):
        text = self.succeed('plan', '--lights', 'key,fill,back', '--gels', 'L106,L139,L119,L101').stdout
        rows = [line.split() for line in text.splitlines()]
        self.assertIn(['shot', 'key', 'fill', 'back'], rows)
        shots = [row for row in rows if len(row) == 4 and row[0].isdigit()]
        self.assertEqual([row[0] for row in shots], ['1', '2', '3'])
        for row in shots:
            self.assertEqual(len(set(row[1:])), 3)
            self.assertTrue(set(row[1:]) <= {'L106', 'L139', 'L119', 'L101'}, row)
        for word in ('amplification', 'singular values', 'error of beta', 'full well 20000', 'minimised'):
            self.assertIn(word, text)

    def test_the_json_holds_the_plan_and_what_it_is_worth(self):
        plan = self.succeed_json('plan', '--lights', 4, '--colors', PAPER)
        self.assertEqual(plan['lights'], ['key', 'fill', 'back', 'kicker'])
        self.assertEqual([len(shot) for shot in plan['shots']], [4] * 4)
        self.assertTrue(plan['exhaustive'])
        self.assertAlmostEqual(plan['predicted']['lambert']['contribution'], .0287, delta=.001)
        self.assertAlmostEqual(plan['predicted']['transport']['contribution'], .0764, delta=.002)
        for channel in plan['conditioning']['channels']:
            s = channel['singular_values']
            self.assertAlmostEqual(channel['condition'], s[0] / s[-1], delta=1e-3 * channel['condition'])
            self.assertAlmostEqual(channel['amplification'], math.sqrt(sum(1 / v ** 2 for v in s) / 4),
                                   delta=1e-3 * channel['amplification'])

    def test_more_light_and_more_shots_mean_less_noise(self):
        def error(*options):
            return self.succeed_json('plan', '--lights', 2, '--colors', '.9/.2/.15 .15/.8/.25',
                                     *options)['predicted']['lambert']
        usual = error()
        for options in (('--exposure', 1), ('--full-well', 80000), ('--read', 0), ('--shots', 4)):
            self.assertLess(error(*options)['contribution'], usual['contribution'], options)
            self.assertLess(error(*options)['beta'], usual['beta'], options)

    def test_panels_are_the_colours_where_none_are_named(self):
        plan = self.succeed_json('plan', '--lights', 3)
        self.assertEqual(plan, self.succeed_json('plan', '--lights', 3, '--colors', 'panels'))
        self.assertEqual(plan['conditioning']['advice'], [])

    def test_a_gel_table_serves(self):
        table = self.path('gels.csv')
        with open(table, 'w') as file:
            file.write('brand,number,name,x,y,T\nOwn,1,Red,.6,.33,.3\nOwn,2,Blue,.18,.15,.2\n')
        plan = self.succeed_json('plan', '--lights', 2, '--gels', table)
        self.assertEqual({color['name'] for color in plan['shots'][0]}, {'O1', 'O2'})

    def test_degenerate_plans_are_named_in_words(self):
        same = self.succeed('plan', '--lights', 'key,fill', '--colors', '#808080,#808080').stdout
        self.assertIn('key and fill have the same colour in every photograph', same)
        near = self.succeed('plan', '--lights', 'key,fill', '--colors', '.5/.4/.3,.6/.35/.3').stdout
        self.assertIn("key and fill are nearly the same colour: the noise of their difference is amplified 15 times; "
                      "move fill's hue away from key's", near)
        rgbw = self.succeed_json('plan', '--lights', 4, '--colors', '1/0/0,0/1/0,0/0/1,1/1/1')
        self.assertEqual([channel['amplification'] for channel in rgbw['conditioning']['channels']], [None] * 3)
        self.assertIsNone(rgbw['predicted']['transport']['contribution'])
        self.assertIsNotNone(rgbw['predicted']['lambert']['contribution'])
        bright = self.succeed('plan', '--lights', 2, '--exposure', 3).stdout
        self.assertIn('typical pixels clip', bright)

    def test_bad_input_is_one_line(self):
        self.deny('plan', naming='--lights')
        self.deny('plan', '--lights', 1, naming=['--lights', '2 to 16'])
        self.deny('plan', '--lights', 99, naming=['--lights', '2 to 16'])
        self.deny('plan', '--lights', 'key,key', naming='key')
        self.deny('plan', '--lights', 3, '--colors', '1/0/0,0/1/0', naming=['need 3 colours', '--repeat'])
        self.deny('plan', '--lights', 2, '--colors', '1/0/0,purple', naming='purple')
        self.deny('plan', '--lights', 2, '--colors', '1/0/0,1/-1/0', naming='1/-1/0')
        self.deny('plan', '--lights', 2, '--colors', '0/0/0,0/0/0', naming='black')
        self.deny('plan', '--lights', 2, '--gels', 'L106,L9999', naming='L9999')
        self.deny('plan', '--lights', 2, '--gels', self.path('no.csv'), naming='no.csv')
        self.deny('plan', '--lights', 6, '--shots', 2, naming=['--shots', 'at least 3'])
        self.deny('plan', '--lights', 3, '--shots', 2, '--model', 'transport', naming='at least 3 shots')
        self.deny('plan', '--lights', 2, '--shots', 0, naming='--shots')
        self.deny('plan', '--lights', 2, '--read', 'nan', naming='--read')
        self.deny('plan', '--lights', 2, '--full-well', 0, naming='--full-well')
        self.deny('plan', '--lights', 2, '--coding', 'spiral', naming=['spiral', 'rotation'])
        self.deny('plan', '--lights', 2, '--model', 'gloss', naming='--model')


if __name__ == '__main__':
    cli.main()
