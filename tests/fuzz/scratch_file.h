#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace hipmap {

/// A file of this process alone, which the readers under test open by name; gone at exit.
class ScratchFile {
  public:
    explicit ScratchFile(const std::string& name)
        : folder_(std::filesystem::temp_directory_path() /
                  ("hipmap_fuzz_" + std::to_string(getpid()))),
          path_(folder_ / name)
    {
        std::filesystem::create_directories(folder_);
    }
    ~ScratchFile()
    {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    const std::filesystem::path& write(const std::uint8_t* data, std::size_t size) const
    {
        std::ofstream out(path_, std::ios::binary | std::ios::trunc);
        out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
        return path_;
    }

  private:
    std::filesystem::path folder_;
    std::filesystem::path path_;
};

} // namespace hipmap
