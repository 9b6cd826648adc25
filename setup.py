"""For `python3 -m pip install .`, with or without ROS on the machine: CMake builds the engine, setuptools packs it with
what is written in Python. catkin builds and installs the package by CMake alone."""
import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class BuildByCmake(build_ext):
    def build_extension(self, ext):
        built = pathlib.Path(self.build_temp).resolve()
        packages = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve().parent.parent
        subprocess.run(["cmake", "-S", ROOT, "-B", built, "-DCMAKE_BUILD_TYPE=Release", "-DRATCHET_SIEVE_ROS=OFF",
                        "-DCATKIN_ENABLE_TESTING=OFF", f"-DPython_EXECUTABLE={sys.executable}",
                        f"-DRATCHET_SIEVE_ENGINE_DIRECTORY={packages}/ratchet_sieve"], check=True)
        subprocess.run(["cmake", "--build", built, "--parallel", str(len(os.sched_getaffinity(0))), "--target", "ratchet_sieve_engine"], check=True)


setup(version=re.search(r"<version>(.+)</version>", (ROOT / "package.xml").read_text()).group(1),
      ext_modules=[Extension("ratchet_sieve._engine", [])], cmdclass={"build_ext": BuildByCmake})
