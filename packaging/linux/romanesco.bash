# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: Romanesco authors
# shellcheck shell=bash
#
# Completion for bash. Commands and options are those that the program tells itself.

_romanesco() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} program=${COMP_WORDS[0]} commands
    COMPREPLY=()
    commands=$("$program" --help 2>/dev/null | sed -n 's/^romanesco \([a-z]\{1,\}\) .*/\1/p')
    case $before in
        --collider) mapfile -t COMPREPLY < <(compgen -W "exact approximate greedy octree bvh simple" -- "$word"); return ;;
    esac
    if [ "$COMP_CWORD" -eq 1 ] && [[ $word != -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$word")
    elif [[ $word == -* ]]; then
        local options="--help --version"
        [ "$COMP_CWORD" -eq 1 ] || options=$("$program" "${COMP_WORDS[1]}" --help 2>/dev/null |
            grep -oE '^ +(-[a-z], )?--[a-z-]+|^ +-[a-z]' | grep -oE -- '--?[a-z][a-z-]*')
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
        return
    fi
    compopt -o filenames 2>/dev/null
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$word")
}
complete -F _romanesco romanesco
