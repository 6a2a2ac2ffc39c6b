# SPDX-License-Identifier: GPL-3.0-or-later
# Options are those that the program's own --help lists, values those that it lists; all else is a file.
_physics_inspector() {
    local program=$1 word=$2 before=$3
    case $before in
        --stepper | --compare) COMPREPLY=($(compgen -W "$("$program" --list-steppers 2>/dev/null | grep -oE '^[a-z][a-z0-9-]*')" -- "$word")) ;;
        *)
            if [[ $word == -* ]]; then
                COMPREPLY=($(compgen -W "$("$program" --help 2>/dev/null | grep -oE '^  (-[a-z], )?--[a-z][a-z0-9-]*' | grep -oE -- '--.*')" -- "$word"))
            else
                COMPREPLY=()
                compopt -o default # readline's own, which quotes names with blanks
            fi
            ;;
    esac
}
complete -F _physics_inspector physics-inspector mazegen
