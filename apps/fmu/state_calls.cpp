// SPDX-License-Identifier: BSD-3-Clause
#include "fmu/state_calls.h"

#include <cstring>
#include <stdexcept>
#include <string>

namespace trivet::fmu {

Outcome get_state(void* instance, const char* function, void** state) {
  return guarded_call(instance, function, phase::any, [&](Instance& self) {
    void*& target = place(state, "the pointer to the state");
    target = self.save(target);
  });
}

Outcome set_state(void* instance, const char* function, void* state) {
  return guarded_call(instance, function, phase::any, [&](Instance& self) { self.restore(state); });
}

Outcome free_state(void* instance, const char* function, void** state) {
  return guarded_call(instance, function, phase::any, [&](Instance& self) {
    void*& target = place(state, "the pointer to the state");
    if (target != nullptr) self.forget(target);
    target = nullptr;
  });
}

Outcome serialized_state_size(void* instance, const char* function, void* state, std::size_t* size) {
  return guarded_call(instance, function, phase::any,
                      [&](Instance& self) { place(size, "the pointer to the size") = self.bytes(state).size(); });
}

Outcome serialize_state(void* instance, const char* function, void* state, void* bytes, std::size_t size) {
  return guarded_call(instance, function, phase::any, [&](Instance& self) {
    const std::string content = self.bytes(state);
    check_count(size, content.size(), "the number of bytes");
    if (bytes == nullptr) throw std::runtime_error("the array of bytes is a null pointer");
    std::memcpy(bytes, content.data(), content.size());
  });
}

Outcome deserialize_state(void* instance, const char* function, const void* bytes, std::size_t size, void** state) {
  return guarded_call(instance, function, phase::any, [&](Instance& self) {
    void*& target = place(state, "the pointer to the state");
    const auto content = array(static_cast<const char*>(bytes), size, "the array of bytes");
    target = self.save_bytes(std::string(content.begin(), content.end()), target);
  });
}

}  // namespace trivet::fmu
