// SPDX-License-Identifier: Apache-2.0
#include "engine/report/sha256.h"

#include <openssl/evp.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "engine/cloud/record.h"
#include "engine/error.h"
#include "engine/report/product_files.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = 1u << 20;

EVP_MD_CTX* context_of(const std::shared_ptr<void>& held) {
  return static_cast<EVP_MD_CTX*>(held.get());
}

void add_file(Sha256& sum, const fs::path& folder, const std::string& name, std::vector<char>& piece) {
  const fs::path path = folder / name;
  std::ifstream file(path, std::ios::binary);
  const std::uint64_t size = file ? fs::file_size(path) : 0;
  std::byte size_bytes[8];
  store(size_bytes, size);
  sum.update(std::as_bytes(std::span(name.c_str(), name.size() + 1)));
  sum.update(size_bytes);
  std::uint64_t seen = 0;
  while (file && seen < size) {
    file.read(piece.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(piece.size(), size - seen)));
    const auto got = static_cast<std::size_t>(file.gcount());
    sum.update(std::as_bytes(std::span(piece.data(), got)));
    seen += got;
  }
  if (!file || seen != size) throw Error(path.string() + ": cannot be read back for the result hash");
}

}  // namespace

Sha256::Sha256() : context_(EVP_MD_CTX_new(), [](void* held) { EVP_MD_CTX_free(static_cast<EVP_MD_CTX*>(held)); }) {
  if (!context_ || EVP_DigestInit_ex(context_of(context_), EVP_sha256(), nullptr) != 1) {
    throw Error("SHA-256 is not available: check the installation of OpenSSL");
  }
}

void Sha256::update(std::span<const std::byte> bytes) {
  if (EVP_DigestUpdate(context_of(context_), bytes.data(), bytes.size()) != 1) throw Error("SHA-256 failed");
}

std::string Sha256::hex() {
  unsigned char digest[32];
  unsigned int size = 0;
  if (EVP_DigestFinal_ex(context_of(context_), digest, &size) != 1 || size != 32) throw Error("SHA-256 failed");
  std::string text;
  for (unsigned char byte : digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

std::string result_hash(const fs::path& folder, const fs::path& store) {
  Sha256 sum;
  std::vector<char> piece(kPiece);
  for (const std::string& name : product_files(folder, store)) add_file(sum, folder, name, piece);
  return sum.hex();
}

}  // namespace ilot
