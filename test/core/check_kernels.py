#!/usr/bin/python3
"""Checks that the object files of the SIMD kernels (of all that are given, those named so) define their kernel for
others and nothing else: what they share with another file the linker could take from one that is compiled for
registers that a machine does not have."""
import pathlib
import subprocess
import sys


def shared(path):
    listing = subprocess.run(['nm', '--extern-only', '--defined-only', '--format=posix', path], check=True,
                             stdout=subprocess.PIPE, universal_newlines=True).stdout
    return [line.split()[0] for line in listing.splitlines()]


def main():
    kernels = [path for path in sys.argv[1:] if pathlib.Path(path).name.startswith('batch_kernel_')]
    wrong = [f'{path}: {name}' for path in kernels for name in shared(path) if 'KERNEL_OF_' not in name]
    print(f'{len(kernels)} kernels', *wrong, sep='\n')
    sys.exit(1 if wrong or len(kernels) != 3 else 0)


if __name__ == '__main__':
    main()
