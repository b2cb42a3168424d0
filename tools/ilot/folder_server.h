// SPDX-License-Identifier: Apache-2.0
// A small server of one folder's files on the loopback address, for a browser on the same machine.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ilot {

// What a request asks for, and how it is answered: a file below the folder, or a status without a file.
struct FolderAnswer {
  int status = 200;
  std::filesystem::path file;  // with 200
  bool with_content = true;    // false for HEAD
};

// Decides about a request, which is not trusted. Only GET and HEAD of regular files below the folder are answered;
// names that begin with a dot, links that lead out of the folder, and hosts other than this machine's own names are
// refused.
FolderAnswer answer_to(std::string_view request, const std::filesystem::path& folder, std::uint16_t port);

// The type of a file for browsers, by its extension.
std::string_view media_type(const std::filesystem::path& file);

class FolderServer {
 public:
  // Listens on 127.0.0.1. Port 0 takes any that is free. Throws Error.
  FolderServer(const std::filesystem::path& folder, std::uint16_t port);
  ~FolderServer();
  FolderServer(const FolderServer&) = delete;
  FolderServer& operator=(const FolderServer&) = delete;

  std::uint16_t port() const { return port_; }

  // Answers one request after the other until `stopped` returns true; asks it five times a second.
  void serve(const std::function<bool()>& stopped) const;

 private:
  std::filesystem::path folder_;
  std::uint16_t port_ = 0;
  int socket_ = -1;
};

}  // namespace ilot
