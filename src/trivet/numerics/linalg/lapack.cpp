// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/numerics/linalg/lapack.h"

#include <dlfcn.h>
#include <pthread.h>
#include <signal.h>

#include <cassert>
#include <complex>
#include <vector>

#include "trivet/foundation/index.h"

namespace trivet::numerics::lapack {
namespace {

using Complex = std::complex<double>;
using Dsyevd = void(const char* job, const char* triangle, const int* n, double* a, const int* rows, double* values,
                    double* work, const int* work_size, int* whole_work, const int* whole_size, int* info);
using Dgeev = void(const char* left, const char* right, const int* n, double* a, const int* rows, double* real,
                   double* imaginary, double* left_vectors, const int* left_rows, double* right_vectors,
                   const int* right_rows, double* work, const int* work_size, int* info);
using Zgeev = void(const char* left, const char* right, const int* n, Complex* a, const int* rows, Complex* values,
                   Complex* left_vectors, const int* left_rows, Complex* right_vectors, const int* right_rows,
                   Complex* work, const int* work_size, double* real_work, int* info);

/// The library is loaded when it is first needed: most models never need it, and linked to the program, OpenBLAS would
/// start its threads before main blocks signals, and receive them.
struct Library {
  Dsyevd* dsyevd = nullptr;
  Dgeev* dgeev = nullptr;
  Zgeev* zgeev = nullptr;

  Library() {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);  // threads inherit the mask
    void* const handle = dlopen("liblapack.so.3", RTLD_NOW | RTLD_LOCAL);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    if (handle != nullptr) {
      find(handle, "dsyevd_", dsyevd);
      find(handle, "dgeev_", dgeev);
      find(handle, "zgeev_", zgeev);
      // One thread: OpenBLAS threads wait actively, and sums in pieces of another size would round differently from
      // machine to machine. Other libraries of LAPACK do not have this function.
      void (*set_threads)(int) = nullptr;
      find(handle, "openblas_set_num_threads", set_threads);
      if (set_threads != nullptr) set_threads(1);
    }
  }

  [[nodiscard]] bool complete() const { return dsyevd != nullptr && dgeev != nullptr && zgeev != nullptr; }

 private:
  template <typename Function>
  static void find(void* handle, const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(dlsym(handle, name));
  }
};

const Library& library() {
  static const Library loaded;
  return loaded;
}

}  // namespace

bool is_available() { return library().complete(); }

bool symmetric_eigen(Eigen::MatrixXd& matrix, Eigen::VectorXd& values, bool with_vectors) {
  assert(is_available() && matrix.rows() == matrix.cols() && matrix.allFinite() && "it may not return from NaN");
  const char job = with_vectors ? 'V' : 'N', lower = 'L';
  const int n = static_cast<int>(matrix.rows()), ask = -1;
  values.resize(n);
  double size = 0;
  int whole_size = 0, info = 0;
  library().dsyevd(&job, &lower, &n, matrix.data(), &n, values.data(), &size, &ask, &whole_size, &ask, &info);
  std::vector<double> work(to_size(static_cast<long>(size)));
  std::vector<int> whole(to_size(whole_size));
  const int work_size = static_cast<int>(work.size());
  library().dsyevd(&job, &lower, &n, matrix.data(), &n, values.data(), work.data(), &work_size, whole.data(),
                   &whole_size, &info);
  return info == 0;
}

bool general_eigen(Eigen::MatrixXd matrix, Eigen::VectorXcd& values, Eigen::MatrixXcd* vectors) {
  assert(is_available() && matrix.rows() == matrix.cols() && matrix.allFinite() && "it may not return from NaN");
  const char none = 'N', wanted = vectors ? 'V' : 'N';
  const int n = static_cast<int>(matrix.rows()), ask = -1, one = 1;
  Eigen::VectorXd real(n), imaginary(n);
  Eigen::MatrixXd right(vectors ? n : 1, vectors ? n : 1);
  double size = 0;
  int info = 0;
  const int right_rows = static_cast<int>(right.rows());
  library().dgeev(&none, &wanted, &n, matrix.data(), &n, real.data(), imaginary.data(), nullptr, &one, right.data(),
                  &right_rows, &size, &ask, &info);
  std::vector<double> work(to_size(static_cast<long>(size)));
  const int work_size = static_cast<int>(work.size());
  library().dgeev(&none, &wanted, &n, matrix.data(), &n, real.data(), imaginary.data(), nullptr, &one, right.data(),
                  &right_rows, work.data(), &work_size, &info);
  values = real.cast<Complex>() + Complex(0, 1) * imaginary.cast<Complex>();
  if (vectors) {
    vectors->resize(n, n);
    for (Eigen::Index k = 0; k < n; ++k)
      if (imaginary(k) > 0 && k + 1 < n) {  // a conjugate pair: real and imaginary part in two columns
        vectors->col(k) = right.col(k).cast<Complex>() + Complex(0, 1) * right.col(k + 1).cast<Complex>();
        vectors->col(k + 1) = vectors->col(k).conjugate();
        ++k;
      } else {
        vectors->col(k) = right.col(k).cast<Complex>();
      }
  }
  return info == 0;
}

bool general_eigen(Eigen::MatrixXcd matrix, Eigen::VectorXcd& values, Eigen::MatrixXcd* vectors) {
  assert(is_available() && matrix.rows() == matrix.cols() && matrix.allFinite() && "it may not return from NaN");
  const char none = 'N', wanted = vectors ? 'V' : 'N';
  const int n = static_cast<int>(matrix.rows()), ask = -1, one = 1;
  values.resize(n);
  Eigen::MatrixXcd right(vectors ? n : 1, vectors ? n : 1);
  std::vector<double> real_work(to_size(2 * n));
  Complex size = 0;
  int info = 0;
  const int right_rows = static_cast<int>(right.rows());
  library().zgeev(&none, &wanted, &n, matrix.data(), &n, values.data(), nullptr, &one, right.data(), &right_rows, &size,
                  &ask, real_work.data(), &info);
  std::vector<Complex> work(to_size(static_cast<long>(size.real())));
  const int work_size = static_cast<int>(work.size());
  library().zgeev(&none, &wanted, &n, matrix.data(), &n, values.data(), nullptr, &one, right.data(), &right_rows,
                  work.data(), &work_size, real_work.data(), &info);
  if (vectors) *vectors = std::move(right);
  return info == 0;
}

}  // namespace trivet::numerics::lapack
