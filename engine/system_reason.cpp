// SPDX-License-Identifier: Apache-2.0
#include "engine/system_reason.h"

#include <cerrno>
#include <cstring>

namespace ilot {
namespace {

const char* advice(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "; free some space or choose another disk";
    case EFBIG:
      return "; the limit of the size of a file is reached (ulimit -f): raise it or choose another disk";
    case EMFILE:
    case ENFILE:
      return "; the limit of open files is reached (ulimit -n): raise it or give fewer --threads";
    case EACCES:
    case EPERM:
    case EROFS:
      return "; change the permissions or choose another folder";
    default:
      return "";
  }
}

}  // namespace

std::string system_reason(int error) {
  return std::string(std::strerror(error)) + advice(error);
}

}  // namespace ilot
