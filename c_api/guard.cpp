// SPDX-License-Identifier: Apache-2.0
#include "c_api/guard.h"

#include <cstdlib>
#include <cstring>
#include <new>

namespace ilot::c {

namespace {

// Of the thread, as errno is: a text in a handle could not say why there is no handle. Fixed, so that it cannot fail.
thread_local char g_sentence[2048] = "";

}  // namespace

ilot_status fault(ilot_status status, const char* sentence) noexcept {
  std::strncpy(g_sentence, sentence, sizeof(g_sentence) - 1);
  return status;
}

ilot_status fault_of_exception() noexcept {
  try {
    throw;
  } catch (const Error& thrown) {
    return fault(static_cast<ilot_status>(thrown.code()), thrown.what());
  } catch (const std::bad_alloc&) {
    return fault(ILOT_FAILED, "memory ran out");
  } catch (const std::exception& thrown) {
    return fault(ILOT_FAILED, thrown.what());
  } catch (...) {
    return fault(ILOT_FAILED, "an unknown fault");
  }
}

void need(const void* pointer, const char* name) {
  if (pointer == nullptr) throw Error(std::string(name) + ": NULL is given, which is not allowed", ExitCode::usage);
}

PointArrays points_of(const double* x, const double* y, const double* z, std::size_t points) {
  need(x, "x");
  need(y, "y");
  need(z, "z");
  return {{x, points}, {y, points}, {z, points}};
}

void* allocate(std::size_t bytes) {
  void* made = std::malloc(bytes > 0 ? bytes : 1);
  if (made == nullptr) throw std::bad_alloc();
  return made;
}

char* copy_of(const std::string& text) {
  auto* made = static_cast<char*>(allocate(text.size() + 1));
  std::memcpy(made, text.c_str(), text.size() + 1);
  return made;
}

char* text_of(const nlohmann::json& json) {
  return copy_of(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace ilot::c

extern "C" const char* ilot_last_error(void) {
  return ilot::c::g_sentence;
}

extern "C" void ilot_free(void* allocated) {
  std::free(allocated);
}
