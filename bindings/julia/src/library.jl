# Finding the library, and what it says of itself.

const binding_version = VersionNumber(AMST_VERSION_MAJOR, AMST_VERSION_MINOR, AMST_VERSION_PATCH)

"""
    library_version()

Version of the library in use, as a `VersionNumber`.
"""
library_version() = VersionNumber(unsafe_string(amst_version_string()))

"""
    library_has(feature)

Whether the library was built with a feature: `"threads"`.
"""
library_has(feature::AbstractString) = amst_has(feature) != 0

"""
    status_name(code)

Name of a status in `alphamst.h`, e.g. `"AMST_ERR_STALE"` for -9.
"""
status_name(code::Integer) = unsafe_string(amst_status_name(code))

# The path or name that `dlopen` is to be given.
function library_path()
    path = get(ENV, "AMST_LIBRARY", "")
    isempty(path) || return path
    project = Base.active_project()
    if project !== nothing
        note = joinpath(dirname(project), "AMST_LIBRARY")
        isfile(note) && return abspath(joinpath(dirname(project), strip(read(note, String))))
    end
    # The second is what is there without the files for developers.
    found = find_library(["libalphamst", "libalphamst.so.0.1", "libalphamst.0.1", "alphamst"])
    isempty(found) || return found
    error("The library alphamst is not found. Set the environment variable AMST_LIBRARY to its " *
          "file, or write the file's path into a file named AMST_LIBRARY beside the active " *
          "Project.toml, or install the library where the system looks for libraries.")
end

# Before 1.0 the interface may change with the minor number; later libraries only add to it.
function is_compatible(number::Integer)
    major, minor = divrem(number ÷ 100, 100)
    major == AMST_VERSION_MAJOR || return false
    return major == 0 ? minor == AMST_VERSION_MINOR : minor >= AMST_VERSION_MINOR
end

function __init__()
    path = library_path()
    load(path)
    is_compatible(amst_version()) ||
        error("$path is AlphaMST $(library_version()); this package needs $binding_version.")
    return nothing
end
