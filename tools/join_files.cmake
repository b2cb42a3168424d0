# SPDX-License-Identifier: Apache-2.0
# Where ILOT_JOIN_FILES is on (all presets but plain), neighbouring files are compiled together: headers are read and
# templates made once for all of them. What joined files keep in anonymous namespaces needs names that differ.

# Joins the given files of a target, under a name of the group's own.
function(ilot_join_files target group)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${ILOT_JOIN_FILES} UNITY_BUILD_MODE GROUP)
endfunction()

# Joins the files of a target that are in one folder, up to `most` at a time in the order they are listed. Files that
# already have a group keep it; files outside of the source folder are compiled alone.
function(ilot_join_folders target most)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_source_file_property(group ${source} UNITY_GROUP)
    if(IS_ABSOLUTE "${source}" OR group)
      continue()
    endif()
    get_filename_component(folder ${source} DIRECTORY)
    string(REPLACE "/" "_" name "in_${folder}")
    if(NOT DEFINED count_${name})
      set(count_${name} 0)
    endif()
    math(EXPR batch "${count_${name}} / ${most}")
    math(EXPR count_${name} "${count_${name}} + 1")
    ilot_join_files(${target} ${name}_${batch} ${source})
  endforeach()
endfunction()

# Joins a target's files, up to `most` at a time in the order they are listed.
function(ilot_join_all target most)
  get_target_property(sources ${target} SOURCES)
  set(count 0)
  foreach(source IN LISTS sources)
    math(EXPR batch "${count} / ${most}")
    math(EXPR count "${count} + 1")
    ilot_join_files(${target} batch_${batch} ${source})
  endforeach()
endfunction()
