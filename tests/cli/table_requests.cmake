# Wrong requests to `skylut table`. Each names the option, the value and what would be right.
skylut_refuses(table_without_out 2 "--out is required" table)
skylut_refuses(table_out_without_value 2 "--out" table --out)
skylut_refuses(table_out_empty 2 "--out" table "--out=")

skylut_refuses(table_profile_unknown 2 "mars" table --out out --profile mars)
skylut_refuses(table_profile_missing_file 2 "mine.toml" table --out out --profile ./mine.toml)
skylut_refuses(table_profile_broken_toml 2 "mine.toml" table --out out --profile ./mine.toml
  INPUT "mine.toml=name = [unfinished\\n")
skylut_refuses(table_profile_unknown_key 2 "mine.toml.*colour" table --out out --profile ./mine.toml
  INPUT "mine.toml=colour = 3\\n")

skylut_refuses(table_altitude_negative 2 "--altitudes-km '-1'.*0 to 30 km" table --out out --altitudes-km -1)
skylut_refuses(table_altitude_too_high 2 "--altitudes-km '0,31': 31 must lie within 0 to 30 km" table --out out --altitudes-km 0,31)
skylut_refuses(table_altitude_nan 2 "--altitudes-km 'nan'" table --out out --altitudes-km nan)
skylut_refuses(table_altitude_infinite 2 "--altitudes-km 'inf'" table --out out --altitudes-km inf)
skylut_refuses(table_altitude_word 2 "--altitudes-km '6km'" table --out out --altitudes-km 6km)
skylut_refuses(table_altitude_gap 2 "--altitudes-km '0,,6': '' must be a number" table --out out --altitudes-km 0,,6)
skylut_refuses(table_altitude_none 2 "--altitudes-km: its value is missing" table --out out --altitudes-km=)
skylut_refuses(table_altitude_twice 2 "--altitudes-km: 0 .number 3. is given twice, must be different" table --out out --altitudes-km 0,6,0)

skylut_refuses(table_turbidity_negative 2 "--turbidities '-0.1'.*at least 0|within 0" table --out out --turbidities -0.1)
skylut_refuses(table_turbidity_below_1 2 "turbidity 0.5 .preetham-t.*at least 1" table --out out
  --turbidity-kind preetham-t --turbidities 0.5)
skylut_refuses(table_visibility_beyond_clear_air 2 "visibility" table --out out
  --turbidity-kind visibility-km --turbidities 1000)
skylut_refuses(table_turbidity_kind_unknown 2 "linke.*aod500" table --out out --turbidity-kind linke)

skylut_refuses(table_sun_zenith_200 2 "--suns '200:0': zenith angle '200': must be a number within 0 to 99 deg" table --out out --suns 200:0)
skylut_refuses(table_sun_without_azimuth 2 "--suns '45': '45' must be ZENITH:AZIMUTH" table --out out --suns 45)
skylut_refuses(table_sun_azimuth_4000 2 "--suns '45:4000': azimuth '4000'.*-3600 to 3600" table --out out --suns 45:4000)
skylut_refuses(table_sun_word 2 "zenith angle 'high'" table --out out --suns high:0)
skylut_refuses(table_sun_trailing_comma 2 "--suns '45:90,': '' must be" table --out out --suns 45:90,)
skylut_refuses(table_sun_twice 2 "--suns: 45:90 .number 2. is given twice, must be different" table --out out --suns 45:90,45:90)

skylut_refuses(table_wavelengths_empty 2 "700:400 nm is empty" table --out out --wavelengths-nm 700:400:5)
skylut_refuses(table_wavelengths_step_0 2 "step 0 nm" table --out out --wavelengths-nm 400:700:0)
skylut_refuses(table_wavelengths_outside 2 "within 300-1000 nm" table --out out --wavelengths-nm 200:400:5)
skylut_refuses(table_wavelengths_word 2 "LO:HI:STEP" table --out out --wavelengths-nm visible)
skylut_refuses(table_wavelengths_uneven 2 "whole number" table --out out --wavelengths-nm 400:700:7)
skylut_refuses(table_wavelengths_invisible 2 "row 1.*Y" table --out out --wavelengths-nm 900:950:10
  --altitudes-km 0 --turbidities 0 --suns 45:0 WARNS "luminance and colour count only 900-950 nm: 0 %")

skylut_refuses(table_albedo_2 2 "--albedo '2'.*0 to 1" table --out out --albedo 2)
skylut_refuses(table_ozone_negative 2 "--ozone-du '-5'" table --out out --ozone-du -5)
skylut_refuses(table_threads_negative 2 "--threads '-1'" table --out out --threads -1)
skylut_refuses(table_threads_fraction 2 "--threads '1.5'" table --out out --threads 1.5)
skylut_refuses(table_quality_unknown 2 "--quality 'best'.*reference" table --out out --quality best)
skylut_refuses(table_weights_unknown 2 "--weights 'none'.*solid-angle" table --out out --weights none)
skylut_refuses(table_directions_misspelt 2 "--directions 'dom': must be dome, utm271, preetham343 or a CSV file .*did you mean dome" table --out out --directions dom)
skylut_refuses(table_directions_below_90 2 "--directions 'low.csv': zenith_deg 91: must be at most 90" table --out out
  --directions low.csv INPUT "low.csv=zenith_deg,azimuth_deg\\n0,0\\n91,0\\n")
skylut_refuses(table_directions_without_zenith 2 "without a zenith direction" table --out out --directions ring.csv
  --altitudes-km 0 --turbidities 0 --suns 45:0 --wavelengths-nm 400:700:100 --quality draft
  INPUT "ring.csv=zenith_deg,azimuth_deg\\n10,0\\n20,0\\n30,0\\n40,0\\n50,0\\n60,0\\n70,90\\n")
skylut_refuses(table_to_horizon_of_the_report 2 "--to-horizon: needs --directions dome" table --out out --to-horizon --directions utm271)
skylut_refuses(table_latitude_91 2 "91" table --out out --latitude 91)
skylut_refuses(table_latitude_no_angle 2 "48:75N" table --out out --latitude 48:75N)
skylut_refuses(table_longitude_alone 2 "--longitude.*--latitude" table --out out --longitude 2)

skylut_refuses(table_out_is_a_file 2 "--out 'out': a file is in the way" table --out out INPUT out=x)
skylut_refuses(table_out_below_a_file 2 "a file is in the way" table --out out/deeper INPUT out=x)
skylut_refuses(table_csv_is_a_folder 2 "out/table.csv.*directory" table --out out FOLDER out/table.csv)
skylut_refuses(table_maps_is_a_file 2 "a file is in the way" table --out out --save-maps INPUT out/maps=x)

# A device stands for a full disk: nothing may be left beside it.
skylut_refuses(table_json_full 1 "table.json: cannot write: No space left" table --out out
  --altitudes-km 0 --turbidities 0 --suns 45:0 --wavelengths-nm 400:700:100 --quality draft
  LINK out/table.json=/dev/full)

skylut_refuses(table_suns_the_same 2 "--suns: 45:270 .number 2. is given twice" table --out out --suns 45:-90,45:270)
skylut_refuses(table_given_twice 2 "--suns: must be given once, not 2 times" table --out out --suns 45:0 --suns 30:0)
skylut_refuses(table_value_missing 2 "--weights: its value is missing before --save-maps" table --out out --weights --save-maps)
skylut_refuses(table_quality_misspelt 2 "--quality 'refrence': must be .* did you mean reference" table --out out --quality refrence)
skylut_refuses(table_beyond_memory 2 "--wavelengths-nm: 7001 values: needs about .* GB of memory, 0.9[0-9]* GB may be used here: at most [0-9]+ fit"
  table --out out --wavelengths-nm 300:1000:0.1 MEMORY_KB 1000000)
skylut_refuses(table_grid_unknown 2 "--grid 'run'.*utm2005, preetham or runtime|--grid 'run'.*runtime" table --out out
  --grid run)
skylut_refuses(table_grid_of_another_kind 2 "--turbidity-kind aod500: the turbidities of --grid preetham are preetham-t"
  table --out out --grid preetham --turbidity-kind aod500)
