# Completion of wetdeck in bash: installed as share/bash-completion/completions/wetdeck, or source this file.
_wetdeck() {
    local program=$1
    # the script at the root of the sources would build first
    [ -x "${program%/*}/build/release/wetdeck" ] && program=${program%/*}/build/release/wetdeck
    mapfile -t COMPREPLY < <("$program" --complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
    [[ ${#COMPREPLY[@]} -eq 0 || ${COMPREPLY[0]} != -* ]] && compopt -o default 2>/dev/null
    return 0
}
complete -F _wetdeck wetdeck
