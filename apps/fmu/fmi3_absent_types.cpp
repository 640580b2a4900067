// SPDX-License-Identifier: BSD-3-Clause
// All variables have the type Float64. Each function for another type succeeds only for no variables at all.
#include "fmu/fmi3_interface.h"
#include "fmu/fmi3_status.h"
#include "fmu/value_calls.h"

using namespace trivet::fmu;

namespace {

fmi3Status absent(fmi3Instance instance, const char* function, std::size_t count) {
  return fmi3_status(access_absent_type(instance, function, count));
}

}  // namespace

fmi3Status fmi3GetFloat32(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3Float32[],
                          std::size_t) {
  return absent(instance, "fmi3GetFloat32", count);
}

fmi3Status fmi3GetInt8(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3Int8[], std::size_t) {
  return absent(instance, "fmi3GetInt8", count);
}

fmi3Status fmi3GetUInt8(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3UInt8[],
                        std::size_t) {
  return absent(instance, "fmi3GetUInt8", count);
}

fmi3Status fmi3GetInt16(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3Int16[],
                        std::size_t) {
  return absent(instance, "fmi3GetInt16", count);
}

fmi3Status fmi3GetUInt16(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3UInt16[],
                         std::size_t) {
  return absent(instance, "fmi3GetUInt16", count);
}

fmi3Status fmi3GetInt32(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3Int32[],
                        std::size_t) {
  return absent(instance, "fmi3GetInt32", count);
}

fmi3Status fmi3GetUInt32(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3UInt32[],
                         std::size_t) {
  return absent(instance, "fmi3GetUInt32", count);
}

fmi3Status fmi3GetInt64(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3Int64[],
                        std::size_t) {
  return absent(instance, "fmi3GetInt64", count);
}

fmi3Status fmi3GetUInt64(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3UInt64[],
                         std::size_t) {
  return absent(instance, "fmi3GetUInt64", count);
}

fmi3Status fmi3GetBoolean(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3Boolean[],
                          std::size_t) {
  return absent(instance, "fmi3GetBoolean", count);
}

fmi3Status fmi3GetString(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3String[],
                         std::size_t) {
  return absent(instance, "fmi3GetString", count);
}

fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, std::size_t[],
                         fmi3Binary[], std::size_t) {
  return absent(instance, "fmi3GetBinary", count);
}

fmi3Status fmi3GetClock(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, fmi3Clock[]) {
  return absent(instance, "fmi3GetClock", count);
}

fmi3Status fmi3SetFloat32(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3Float32[],
                          std::size_t) {
  return absent(instance, "fmi3SetFloat32", count);
}

fmi3Status fmi3SetInt8(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3Int8[],
                       std::size_t) {
  return absent(instance, "fmi3SetInt8", count);
}

fmi3Status fmi3SetUInt8(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3UInt8[],
                        std::size_t) {
  return absent(instance, "fmi3SetUInt8", count);
}

fmi3Status fmi3SetInt16(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3Int16[],
                        std::size_t) {
  return absent(instance, "fmi3SetInt16", count);
}

fmi3Status fmi3SetUInt16(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3UInt16[],
                         std::size_t) {
  return absent(instance, "fmi3SetUInt16", count);
}

fmi3Status fmi3SetInt32(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3Int32[],
                        std::size_t) {
  return absent(instance, "fmi3SetInt32", count);
}

fmi3Status fmi3SetUInt32(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3UInt32[],
                         std::size_t) {
  return absent(instance, "fmi3SetUInt32", count);
}

fmi3Status fmi3SetInt64(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3Int64[],
                        std::size_t) {
  return absent(instance, "fmi3SetInt64", count);
}

fmi3Status fmi3SetUInt64(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3UInt64[],
                         std::size_t) {
  return absent(instance, "fmi3SetUInt64", count);
}

fmi3Status fmi3SetBoolean(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3Boolean[],
                          std::size_t) {
  return absent(instance, "fmi3SetBoolean", count);
}

fmi3Status fmi3SetString(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3String[],
                         std::size_t) {
  return absent(instance, "fmi3SetString", count);
}

fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const std::size_t[],
                         const fmi3Binary[], std::size_t) {
  return absent(instance, "fmi3SetBinary", count);
}

fmi3Status fmi3SetClock(fmi3Instance instance, const fmi3ValueReference[], std::size_t count, const fmi3Clock[]) {
  return absent(instance, "fmi3SetClock", count);
}
