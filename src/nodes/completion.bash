# Completion in bash: options and subcommands, from --help, and the keys of a scene. Other words are names of files.
# shellcheck shell=bash

_ratchet_sieve()
{
  local program=$1 word=$2 previous=$3 subcommand='' help words='' index=0
  if [ "$previous" = = ]; then return; fi
  if [ "$COMP_CWORD" -gt 1 ] && [ "${program##*/}" = sieve_sweep ]; then subcommand=${COMP_WORDS[1]}; fi
  if [ "$previous" = --set ] || [ "$previous" = --over ]; then
    if [[ $word =~ \.([0-9]+)\. ]]; then index=${BASH_REMATCH[1]}; fi
    words=$("${program%sieve_*}sieve_run" --keys | sed -nE 's/^([a-z][a-z_.N]*)  +.*/\1=/p' | sed "s/\.N\./.$index./")
    compopt -o nospace
  else
    help=$("$program" ${subcommand:+"$subcommand"} --help 2>/dev/null)
    case $word in
      -*) words=$(grep -oE -- '--[a-z][a-z-]*' <<<"$help") ;;
      *) if [ -z "$subcommand" ]; then words=$(sed -nE '/^Subcommands:/,/^$/s/^  ([a-z]+) .*/\1/p' <<<"$help"); fi ;;
    esac
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}

complete -o default -F _ratchet_sieve sieve_run sieve_sweep sieve_separate sieve_analyze sieve_resimulate
