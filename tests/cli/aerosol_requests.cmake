# skylut aerosol. Bohren and Huffman's example: Q 3.10543, g 0.63314.
skylut_prints(mie "\"q_ext\": 3\\.1054[0-9]+,\\s+\"q_sca\": 3\\.1054[0-9]+,\\s+\"asymmetry\": 0\\.6331"
  aerosol mie --size-parameter 5.21282 --index 1.55,0 --json)
skylut_prints(mie_angles "\"angle_deg\": \\[\\s*0\\.0,\\s*90\\.0,\\s*180\\.0\\s*\\],\\s*\"phase_function\": \\["
  aerosol mie --size-parameter 1 --index 1.5,0.1 --angles 0:180:90 --json)
skylut_prints(mie_table "asymmetry +0\\.6331[0-9]+\\s+angle/deg +phase function" aerosol mie --size-parameter 5.21282 --index 1.55,0 --angles 0,90)

skylut_refuses(aerosol_alone 2 "subcommand" aerosol)
skylut_refuses(mie_without_size 2 "--size-parameter is required" aerosol mie --index 1.5,0)
skylut_refuses(mie_size 2 "--size-parameter '0': must be a number within 1e-06 to 100000" aerosol mie --size-parameter 0 --index 1.5,0)
skylut_refuses(mie_index 2 "--index '1.5': must be RE,IM" aerosol mie --size-parameter 1 --index 1.5)
skylut_refuses(mie_gain 2 "imaginary part '-0.1'.*0 to 20" aerosol mie --size-parameter 1 --index 1.5,-0.1)
skylut_refuses(mie_invisible 2 "refractive index 1: must differ" aerosol mie --size-parameter 1 --index 1,0)
skylut_refuses(mie_angle 2 "--angles '190': must be a number within 0 to 180" aerosol mie --size-parameter 1 --index 1.5,0 --angles 190)
skylut_refuses(mie_angle_steps 2 "--angles '0:10:3'" aerosol mie --size-parameter 1 --index 1.5,0 --angles 0:10:3)

skylut_prints(aerosols "maritime-clean +Sea.*\n(.*\n)*rural +Rural" aerosol list)
skylut_prints(aerosol_show "rural: .*\n(.*\n)*Angstrom exponents\n +350-500 nm +0\\.9" aerosol show rural)
skylut_prints(aerosol_show_json "\"humidity_percent\": 90" aerosol show urban --humidity 90 --json)
skylut_refuses(aerosol_unknown 2 "aerosol 'mars': must be one of .*rural" aerosol show mars)
skylut_refuses(aerosol_missing_file 2 "aerosol 'mine.toml': no such file" map -o sky.csv --sun-zenith-deg 45 --aerosol mine.toml)
skylut_refuses(aerosol_dry 2 "humidity 80 %.*rural" table --out out --aerosol rural --humidity 80)
skylut_refuses(aerosol_humidity 2 "--humidity '120': must be a number within 0 to 99 %" aerosol show urban --humidity 120)
skylut_refuses(aerosol_file_key 2 "mine.toml:6: component\\[0\\].sigma_g: is 0.5; must lie within 1.01 to 10" aerosol show mine.toml
  INPUT "mine.toml=name = 'm'\\ndescription = 'd'\\nsource = 's'\\n[[component]]\\nname = 'c'\\nsigma_g = 0.5\\n")
