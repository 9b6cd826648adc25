# Sourced by the scripts beside it: where things are, how to speak, and ROS's environment.
# shellcheck shell=bash disable=SC2034

project_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=$project_dir/build
devel_dir=$project_dir/devel

# A python that comes first on PATH (pyenv, conda) knows nothing of ROS's modules in /usr.
export PATH=/usr/bin:$PATH

# Everything runs on this machine: no name of it has to resolve but localhost.
export ROS_HOSTNAME=localhost
unset ROS_IP

# Prints the comment at the head of the script: its usage.
usage()
{
  sed -n '2,/^[^#]/s/^# \?//p' "$0"
}

say()
{
  printf '\n== %s\n' "$*"
}

fail()
{
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# Sources a setup file of ROS, which does not stand up to `set -u`.
source_ros()
{
  set +u
  # shellcheck disable=SC1090
  . "$1"
  set -u
}

# True where ROS comes as Noetic under /opt/ros, and not from the distribution's archive.
is_noetic()
{
  [ -e /opt/ros/noetic/setup.bash ] || grep -qs '^VERSION_CODENAME=focal' /etc/os-release
}

# Puts ROS on the paths; where it comes from Debian's archive it is there already.
enter_ros()
{
  if [ -e /opt/ros/noetic/setup.bash ]; then source_ros /opt/ros/noetic/setup.bash; fi
}

# Sees to the Python package with the engine for browsers, in the directory `modules`: builds it where it is missing,
# into build/ where the package was built with ROS, else without ROS.
ensure_web_engine()
{
  if is_noetic; then fail "Ubuntu 20.04's Emscripten is too old: use Debian 12"; fi
  modules=$devel_dir/lib/python3/dist-packages
  if [ -e "$modules/ratchet_sieve/engine.wasm" ]; then
    :
  elif compgen -G "$modules/ratchet_sieve/_engine.*" >/dev/null; then
    "$project_dir/scripts/setup" --web >&2
    "$project_dir/scripts/build" --web --target ratchet_sieve_engine >&2
  else
    built=$build_dir/without_ros
    modules=$built/python
    "$project_dir/scripts/setup" --without-ros --web >&2
    "$project_dir/scripts/build" --web --dir "$built" -DRATCHET_SIEVE_ROS=OFF --target ratchet_sieve_engine >&2
  fi
}
