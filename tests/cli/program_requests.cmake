# The program as a whole.
skylut_prints(version "^skylut [0-9]+\\.[0-9]+\\.[0-9]+\n$" --version)
skylut_prints(help "Exit codes: 0 done, 1 the work failed, 2 the request was wrong" --help)
skylut_prints(table_help "--altitudes-km LIST" table --help)
skylut_prints(map_help "--sun-zenith-deg NUMBER" map --help)

skylut_refuses(no_command 2 "subcommand.*skylut --help")
skylut_refuses(unknown_command 2 "command 'tabel': must be one of table, map" tabel)
skylut_refuses(unknown_flag 2 "--alitude.*skylut table --help" table --out out --alitude 3)
skylut_refuses(stray_argument 2 "more" table --out out more)
skylut_refuses(full_standard_output 1 "standard output: cannot write" --help STDOUT_TO /dev/full)
