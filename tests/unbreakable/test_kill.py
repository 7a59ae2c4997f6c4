"""Verbs killed at random moments leave whole files or none, and do it again. scripts/kill_verbs does it a thousand
times."""
import cli
from killed_verb import Killer


class KillTest(cli.CliTest):
    def test_killed_verbs_leave_whole_files(self):
        killer = Killer(self.folder, seed=1)
        for _ in range(5):
            killer.kill(3)


if __name__ == '__main__':
    cli.main()
