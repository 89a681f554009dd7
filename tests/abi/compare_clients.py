"""compare_clients.py CLIENT...: programs that differ in the header that they were built with print the same."""

import difflib
import subprocess
import sys


def printed(client):
    done = subprocess.run([client], capture_output=True, text=True, timeout=300)
    if done.returncode or not done.stdout:
        sys.exit(f"{client} ended with {done.returncode}: {done.stderr}")
    return done.stdout.splitlines()


def main(first, *others):
    expected = printed(first)
    differences = [line for other in others for line in difflib.unified_diff(expected, printed(other), first, other)]
    return "\n".join(differences) if differences else 0


sys.exit(main(*sys.argv[1:]))
