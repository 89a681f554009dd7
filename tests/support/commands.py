"""Commands that tests run."""

import subprocess


class Failed(Exception):
    """A command failed that must not."""


def run(*command, **options):
    """What it printed; Failed with the command and all that it said otherwise."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        raise Failed(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout
