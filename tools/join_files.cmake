# SPDX-License-Identifier: Apache-2.0
# Where ILOT_JOIN_FILES is on (the dev preset), files that share heavy headers are compiled together: headers are read
# and templates made once for all of them. What joined files keep in anonymous namespaces needs names that differ.

# Joins the given files of a target, under a name of the group's own.
function(ilot_join_files target group)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${ILOT_JOIN_FILES} UNITY_BUILD_MODE GROUP)
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
