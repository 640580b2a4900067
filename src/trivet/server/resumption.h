// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace trivet::server {

/// What lets a page of an earlier start for the same project go on with a new one, which has another token: the port,
/// and a key that no request carries. Kept in the folder of this user's login (XDG_RUNTIME_DIR) until that ends.
struct Resumption {
  std::uint16_t port = 0;  ///< of the last start; 0: there was none
  std::string key;         ///< 32 random bytes, hexadecimal
};

/// Of the last start for this project. A new key if there was none, or if the user's login has no private folder: by it
/// pages recognise this start of the program, and no other. What other users may read, or what belongs to one of them,
/// is not used. @param log  gets a line about each such folder or file
[[nodiscard]] Resumption last_resumption(const std::string& project_file,
                                         const std::function<void(const std::string&)>& log);
/// Keeps it for the next start in a file that this user alone can read, if there is a private folder for it.
void keep(const Resumption& resumption, const std::string& project_file);

/// The token for a page that has the key, unreadable for every other program, and the proof that the sender has the
/// key. With h = SHA-256, hexadecimal: `sealed` = `token` xor h(key + h(key + "token " + words)), `proof` =
/// h(key + h(key + "proof " + words + " " + token)), words = "PORT PAGE_NONCE NONCE". The port is among them so that a
/// program at another port cannot pass the answer of this one on.
struct SealedToken {
  std::string nonce, sealed, proof;
};
[[nodiscard]] SealedToken sealed_token(const std::string& token, const Resumption& resumption,
                                       const std::string& page_nonce, const std::string& nonce);

}  // namespace trivet::server
