// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/foundation/thread_progress.h"

namespace trivet::foundation {
namespace {

const Progress no_progress;
thread_local const Progress* progress_of_thread = &no_progress;

}  // namespace

ThreadProgress::ThreadProgress(const Progress& progress) : before_(progress_of_thread) {
  progress_of_thread = &progress;
}
ThreadProgress::~ThreadProgress() { progress_of_thread = before_; }

const Progress& thread_progress() { return *progress_of_thread; }

}  // namespace trivet::foundation
