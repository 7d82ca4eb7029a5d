# Completion of robodyn for fish: robodyn completion fish.
# Written by robodyn; do not edit, generate again.

function _robodyn_completion
    set -l response (env COMP_WORDS=(commandline -cp | string collect) \
        _ROBODYN_COMPLETE=fish_complete robodyn 2>/dev/null)
    set -l word (commandline -ct | string collect -a)
    set -l head (string match -r -- '^--[^=]*=' $word; or echo)
    set -l path (string replace -r -- '^--[^=]*=' '' $word)
    for candidate in $response
        set -l parts (string split -m 1 -- , $candidate)
        switch $parts[1]
            case plain
                echo $parts[2]
            case file
                printf '%s\n' $head(__fish_complete_path $path)
            case dir
                printf '%s\n' $head(__fish_complete_directories $path)
        end
    end
end

complete --no-files --command robodyn --arguments "(_robodyn_completion)"
