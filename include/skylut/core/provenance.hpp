#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace skylut {

struct Context;

/// How a file came about. One goes with every file that skylut writes, so that the file explains itself and
/// can be made again: the command, every number as it was used, the sources' hashes, the version and the
/// instruction set that computed it (builds for different ones differ in the last digits of a float).
class Provenance {
 public:
  /// @param command  the command line that makes the same file again, quoted for a shell
  explicit Provenance(std::string command = {});

  /// Adds a description under a name; one of the same name is replaced.
  void describe(const std::string& name, const nlohmann::ordered_json& description);
  void describe(const std::string& name, const std::string& text);

  /// Adds a file that was read, with its hash. Files of the data folder are named relative to it. Known ones
  /// are not added twice. @throws WorkError  if it cannot be read
  void add_source(const Context& context, const std::filesystem::path& file);

  void set_instruction_set(std::string name) { instruction_set_ = std::move(name); }

  const std::string& command() const { return command_; }

  /// {"skylut_version", "command", "instruction_set" (if any was used), "inputs", "sources"}, in that order.
  nlohmann::ordered_json json() const;

  /// The same for a CSV file: "# command: …" and "# provenance: {…}", one line each.
  std::string comment_lines() const;

 private:
  struct Source {
    std::string file;
    std::string sha256;
  };
  std::string command_;
  std::string instruction_set_;
  std::shared_ptr<const nlohmann::ordered_json> inputs_;
  std::vector<Source> sources_;
};

}  // namespace skylut
