# bash completion for replan. Source it, or copy it to /usr/share/bash-completion/completions/replan.

# Offers the words in $1 for the last part of a list "a,b,c".
_replan_list() {
  local done="" part="$cur" word
  case "$cur" in
    *,*) done="${cur%,*}," part="${cur##*,}" ;;
  esac
  for word in $(compgen -W "$1" -- "$part"); do COMPREPLY+=("$done$word"); done
  compopt -o nospace 2>/dev/null
}

# Offers files that end in one of the given extensions, and folders; without extensions folders alone.
_replan_files() {
  local file
  while IFS= read -r file; do
    if [ -d "$file" ]; then
      COMPREPLY+=("$file/")
    else
      case " $* " in *" ${file##*.} "*) COMPREPLY+=("$file") ;; esac
    fi
  done < <(compgen -f -- "$cur")
  compopt -o filenames 2>/dev/null
}

# The first column of "replan list $1", without its head.
_replan_ids() {
  replan list "$1" 2>/dev/null | awk 'NR > 1 && NF == 0 { exit } NR > 1 { print $1 }'
}

_replan_settings() {
  replan list planners --json 2>/dev/null | sed -n 's/^ *"key": "\(.*\)",$/\1=/p' | sort -u
}

_replan_options() {
  case "$1" in
    run) echo "-h --help --map --start --goal --unreachable-goal --robot --radius --threshold --invert --unknown --occupied --height-map --layers --heights --reduce --planner --set --stage --json --csv --markdown --latex --cells --check --trace --trace-map --break" ;;
    batch) echo "-h --help --map --threshold --invert --unknown --occupied --height-map --layers --heights --reduce --planner --set --stage --limit --out --jobs --shard --scenario --open -o --output --json" ;;
    merge) echo "-h --help -o --output" ;;
    compare) echo "-h --help --times --any-settings --alpha --fail-on-loss --tolerate --all --json" ;;
    anytime) echo "-h --help --map --start --goal --unreachable-goal --robot --radius --threshold --invert --unknown --occupied --height-map --layers --heights --reduce --planner --set --stage --seeds --time --csv --svg" ;;
    barn) echo "-h --help --global --set --world --csv" ;;
    study) echo "-h --help --out --seeds --barn --quick --json" ;;
    render)
      echo "-h --help --map --start --goal --unreachable-goal --robot --radius --threshold --invert --unknown --occupied --height-map --layers --heights --reduce --planner --set --stage -o --output --size --scale" \
        "--at --at-end --at-plan" \
        "--overlay --theme --action --dialog --pin --arc --camera --slice --orbit --cut --glass --range --colours --canvas-only --panes --fps --speed --hold --from --to"
      ;;
    convert) echo "-h --help --start --goal --threshold --invert --unknown --occupied --height-map --layers --heights --reduce --slice --planner --set --stage" ;;
    show) echo "-h --help --map --start --goal --unreachable-goal --robot --radius --threshold --invert --unknown --occupied --height-map --layers --heights --reduce --planner --set --stage --at --cell" ;;
    list) echo "-h --help --json" ;;
    *) echo "-h --help --version --in-step" ;;
  esac
}

_replan() {
  local maps="map yaml yml cfg txt csv npy asc png bmp tga pgm ppm pbm pnm gif jpg jpeg" commands="run batch merge compare anytime barn study render convert show list"
  local cur="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD - 1]}" command=""
  COMPREPLY=()
  [ "$COMP_CWORD" -gt 1 ] && command="${COMP_WORDS[1]}"
  case "$before" in
    --planner) _replan_list "all $(_replan_ids planners)"; return ;;
    --global) _replan_list "none $(_replan_ids planners | grep -vxE "dwa|fusion")"; return ;;
    --stage) _replan_list "$(_replan_ids stages)"; return ;;
    --robot) _replan_list "$(_replan_ids robots)"; return ;;
    --overlay) _replan_list "$(_replan_ids overlays)"; return ;;
    --set)
      COMPREPLY=($(compgen -W "$(_replan_settings)" -- "$cur"))
      compopt -o nospace 2>/dev/null
      return
      ;;
    --theme) COMPREPLY=($(compgen -W "light dark" -- "$cur")); return ;;
    --map) _replan_files 3dmap $maps; return ;;
    --unreachable-goal) COMPREPLY=($(compgen -W "wait nearest" -- "$cur")); return ;;
    --unknown) COMPREPLY=($(compgen -W "blocked free unmapped" -- "$cur")); return ;;
    --csv) _replan_files csv; return ;;
    --markdown) _replan_files md; return ;;
    --latex) _replan_files tex; return ;;
    --trace) _replan_files jsonl yaml yml json; return ;;
    --trace-map) _replan_files map; return ;;
    -o | --output)
      case "$command" in
        batch) _replan_files json ;;
        merge) _replan_files ;;
        *) _replan_files png svg gif webp mp4 ;;
      esac
      return
      ;;
    --out) _replan_files; return ;;
    --dialog) COMPREPLY=($(compgen -W "new_world open worlds opening save_as figures film film_window film_run picture trace unsaved changed overwrite recover generate resize batch batch_results edits keys link about menu_file menu_edit menu_world menu_planner menu_run menu_view menu_overlays menu_tabs menu_panes menu_record menu_help" -- "$cur")); return ;;
    --action) _replan_list "$(_replan_ids actions)"; return ;;
    --start | --goal | --radius | --world | --break | --cell | --pin | --arc | --orbit | --camera | --size | --scale | --limit | --jobs | --shard | --scenario | --open | --alpha | --tolerate | --threshold | --occupied | --layers | --heights | --reduce | --slice | --fps | --hold) return ;;
    --panes) COMPREPLY=($(compgen -W "1 2 4 all" -- "$cur")); return ;;
    --colours) COMPREPLY=($(compgen -W "viridis cividis grey" -- "$cur")); return ;;
    --range) COMPREPLY=($(compgen -W "whole-run so-far" -- "$cur")); return ;;
    --speed) COMPREPLY=($(compgen -W "auto expansion move" -- "$cur")); return ;;
    --at | --from | --to) COMPREPLY=($(compgen -W "start plan end replan: move:" -- "$cur")); return ;;
  esac
  case "$cur" in
    -*) COMPREPLY=($(compgen -W "$(_replan_options "$command")" -- "$cur")); return ;;
  esac
  case "$command" in
    run | render | show | anytime) _replan_files json ;;
    batch) _replan_files json scen 3dscen ;;
    merge) _replan_files ;;
    compare) _replan_files json ;;
    barn) _replan_files json ;;
    study) COMPREPLY=($(compgen -W "all dld-table1 dld-surprise dld-random dld-maze astar-table1 fusion auv informed-rrt" -- "$cur")) ;;
    convert) _replan_files json 3dmap $maps ;;
    list) COMPREPLY=($(compgen -W "planners stages robots maps overlays generators terms actions lessons studies" -- "$cur")) ;;
    *)
      _replan_files json $maps
      COMPREPLY+=($(compgen -W "$commands" -- "$cur"))
      ;;
  esac
}

complete -F _replan replan
