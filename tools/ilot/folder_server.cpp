// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/folder_server.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <vector>

#include "engine/error.h"
#include "engine/system_reason.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRequest = 16u << 10;
constexpr int kPatienceMs = 2000;  // for a browser that is silent

// Returns the bytes of a path of a URL; nullopt when it is broken or holds a zero byte.
std::optional<std::string> decoded(std::string_view path) {
  std::string bytes;
  for (std::size_t i = 0; i < path.size(); ++i) {
    int value = static_cast<unsigned char>(path[i]);
    if (path[i] == '%') {
      if (i + 2 >= path.size()) return std::nullopt;
      const auto [end, code] = std::from_chars(path.data() + i + 1, path.data() + i + 3, value, 16);
      if (code != std::errc() || end != path.data() + i + 3) return std::nullopt;
      i += 2;
    }
    if (value == 0) return std::nullopt;
    bytes += static_cast<char>(value);
  }
  return bytes;
}

// A page elsewhere could lead its name to this address. Its requests then carry its name.
bool is_own_host(std::string_view request, std::uint16_t port) {
  std::string lower(request);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  const std::size_t at = lower.find("\r\nhost:");
  if (at == std::string::npos) return false;
  const std::size_t begin = lower.find_first_not_of(' ', at + 7), end = lower.find("\r\n", begin);
  if (begin == std::string::npos || end == std::string::npos) return false;
  const std::string host = lower.substr(begin, end - begin);
  return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
}

// Returns the file below the folder that a path names; nullopt when there is none that may be served.
std::optional<fs::path> file_below(const fs::path& folder, const std::string& path) {
  const fs::path relative = fs::path(path).relative_path();
  for (const fs::path& part : relative)
    if (part.string().starts_with(".")) return std::nullopt;
  std::error_code code;
  const fs::path top = fs::canonical(folder, code), file = code ? fs::path() : fs::canonical(folder / relative, code);
  if (code || !fs::is_regular_file(file, code)) return std::nullopt;
  if (std::mismatch(top.begin(), top.end(), file.begin(), file.end()).first != top.end()) return std::nullopt;
  return file;
}

void send_all(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

std::string read_request(int socket) {
  std::string request;
  std::array<char, 4096> piece{};
  while (request.find("\r\n\r\n") == std::string::npos && request.size() < kMostRequest) {
    pollfd wait{socket, POLLIN, 0};
    if (poll(&wait, 1, kPatienceMs) <= 0) break;
    const ssize_t got = recv(socket, piece.data(), piece.size(), 0);
    if (got <= 0) break;
    request.append(piece.data(), static_cast<std::size_t>(got));
  }
  return request;
}

void send_answer(int socket, const FolderAnswer& answer) {
  std::ifstream file;
  std::uintmax_t size = 0;
  int status = answer.status;
  if (status == 200) {
    std::error_code code;
    size = fs::file_size(answer.file, code);
    file.open(answer.file, std::ios::binary);
    if (code || !file) status = 404;
  }
  const std::string text = status == 200 ? "" : fmt::format("{}\n", status == 404 ? "no such file" : "refused");
  send_all(socket, fmt::format("HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nCache-Control: no-store\r\n"
                               "X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n",
                               status, status == 200 ? "OK" : "Refused",
                               status == 200 ? media_type(answer.file) : std::string_view("text/plain"),
                               status == 200 ? size : text.size()));
  if (!answer.with_content) return;
  send_all(socket, text);
  if (status != 200) return;
  std::vector<char> piece(1u << 16);
  for (; file && size > 0; size -= static_cast<std::uintmax_t>(file.gcount())) {
    file.read(piece.data(), static_cast<std::streamsize>(std::min<std::uintmax_t>(piece.size(), size)));
    if (file.gcount() == 0) return;
    send_all(socket, {piece.data(), static_cast<std::size_t>(file.gcount())});
  }
}

}  // namespace

FolderAnswer answer_to(std::string_view request, const fs::path& folder, std::uint16_t port) {
  const std::string_view line = request.substr(0, request.find("\r\n"));
  const bool get = line.starts_with("GET "), head = line.starts_with("HEAD ");
  if (!get && !head) return {405, {}, true};
  if (!is_own_host(request, port)) return {403, {}, get};
  std::string_view target = line.substr(get ? 4 : 5);
  target = target.substr(0, target.find(' '));
  const auto path = decoded(target.substr(0, target.find_first_of("?#")));
  if (!path || !path->starts_with("/")) return {400, {}, get};
  const auto file = file_below(folder, *path == "/" ? "/report.html" : *path);
  return file ? FolderAnswer{200, *file, get} : FolderAnswer{404, {}, get};
}

std::string_view media_type(const fs::path& file) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 13> kTypes{
      {{".html", "text/html; charset=utf-8"},
       {".js", "text/javascript; charset=utf-8"},
       {".json", "application/json"},
       {".jsonl", "application/jsonl"},
       {".csv", "text/csv; charset=utf-8"},
       {".svg", "image/svg+xml"},
       {".png", "image/png"},
       {".pdf", "application/pdf"},
       {".tif", "image/tiff"},
       {".gpkg", "application/geopackage+sqlite3"},
       {".obj", "model/obj"},
       {".stl", "model/stl"},
       {".dxf", "image/vnd.dxf"}}};
  const std::string extension = file.extension().string();
  for (const auto& [end, type] : kTypes)
    if (extension == end) return type;
  return "application/octet-stream";
}

FolderServer::FolderServer(const fs::path& folder, std::uint16_t port) : folder_(folder) {
  socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  const int yes = 1;
  socklen_t size = sizeof address;
  if (socket_ < 0 || setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0 ||
      bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 || listen(socket_, 16) != 0 ||
      getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    const int reason = errno;
    if (socket_ >= 0) close(socket_);
    throw Error(
        fmt::format("view: cannot listen on 127.0.0.1:{}: {}; give another --port", port, system_reason(reason)));
  }
  port_ = ntohs(address.sin_port);
}

FolderServer::~FolderServer() {
  close(socket_);
}

void FolderServer::serve(const std::function<bool()>& stopped) const {
  constexpr int kAskMs = 200;
  while (!stopped()) {
    pollfd wait{socket_, POLLIN, 0};
    if (poll(&wait, 1, kAskMs) <= 0) continue;
    const int browser = accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
    if (browser < 0) continue;
    timeval patience{kPatienceMs / 1000, 0};
    setsockopt(browser, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    const std::string request = read_request(browser);
    if (!request.empty()) send_answer(browser, answer_to(request, folder_, port_));
    shutdown(browser, SHUT_WR);
    close(browser);
  }
}

}  // namespace ilot
