# Wrong requests to `skylut map`.
skylut_refuses(map_without_output 2 "-o is required" map --sun-zenith-deg 45)
skylut_refuses(map_output_png 2 "sky.png.*csv or .exr" map -o sky.png --sun-zenith-deg 45)
skylut_refuses(map_output_folder_missing 2 "no such folder: missing" map -o missing/sky.csv --sun-zenith-deg 45)
skylut_refuses(map_output_is_a_folder 2 "sky.csv.*directory" map -o sky.csv --sun-zenith-deg 45 FOLDER sky.csv)
skylut_refuses(map_picture_is_a_folder 2 "sky_rgb.exr.*directory" map -o sky.exr --sun-zenith-deg 45
  --channels rgb,xyz FOLDER sky_rgb.exr)
skylut_refuses(map_output_full 1 "sky.csv: cannot write: No space left" map -o sky.csv --sun-zenith-deg 45
  --wavelengths-nm 400:700:100 --quality draft LINK sky.csv=/dev/full)
skylut_refuses(map_picture_full 1 "sky.exr: cannot write: No space left" map -o sky.exr --sun-zenith-deg 45
  --size 4 --wavelengths-nm 400:700:100 --quality draft LINK sky.exr=/dev/full)

skylut_refuses(map_altitude_31 2 "--altitude-km '31'.*0 to 30" map -o sky.csv --sun-zenith-deg 45 --altitude-km 31)
skylut_refuses(map_altitude_negative 2 "--altitude-km '-1'" map -o sky.csv --sun-zenith-deg 45 --altitude-km -1)
skylut_refuses(map_water_negative 2 "--water-cm '-1'.*0 to 20 cm" map -o sky.csv --sun-zenith-deg 45 --water-cm -1)
skylut_refuses(map_no2_word 2 "--no2-du 'much'" map -o sky.csv --sun-zenith-deg 45 --no2-du much)
skylut_refuses(map_pressure_in_pascal 2 "--pressure-hpa '101325'.*300 to 1100 hPa" map -o sky.csv
  --sun-zenith-deg 45 --pressure-hpa 101325)
skylut_refuses(map_turbidity_negative 2 "--turbidity '-0.1'" map -o sky.csv --sun-zenith-deg 45 --turbidity -0.1)
skylut_refuses(map_turbidity_kind_alone 2 "--turbidity-kind: needs --turbidity" map -o sky.csv --sun-zenith-deg 45
  --turbidity-kind preetham-t)

skylut_refuses(map_no_sun 2 "no sun: give --sun-zenith-deg" map -o sky.csv)
skylut_refuses(map_sun_zenith_200 2 "--sun-zenith-deg '200'.*0 to 99" map -o sky.csv --sun-zenith-deg 200)
skylut_refuses(map_sun_azimuth_nan 2 "--sun-azimuth-deg 'nan'" map -o sky.csv --sun-zenith-deg 45
  --sun-azimuth-deg nan)
skylut_refuses(map_sun_twice 2 "--time.*must not be given with --sun-zenith-deg" map -o sky.csv --sun-zenith-deg 45
  --latitude 48 --longitude 2 --time 2024-06-21T09:00Z)
skylut_refuses(map_time_without_place 2 "--time.*--latitude and --longitude" map -o sky.csv --time 2024-06-21T09:00Z)
skylut_refuses(map_time_without_longitude 2 "--time.*--longitude" map -o sky.csv --latitude 48
  --time 2024-06-21T09:00Z)
skylut_refuses(map_time_word 2 "noon" map -o sky.csv --latitude 48 --longitude 2 --time noon)
skylut_refuses(map_time_no_such_day 2 "2024-02-30" map -o sky.csv --latitude 48 --longitude 2
  --time 2024-02-30T12:00Z)
skylut_refuses(map_time_without_zone 2 "2024-06-21T09:00" map -o sky.csv --latitude 48 --longitude 2
  --time 2024-06-21T09:00)
skylut_refuses(map_at_night 2 "--time 2024-06-21T00:00:00Z: the sun is 108.55 deg from the zenith: the sky.s light ends at 99" map -o sky.csv --latitude 48
  --longitude 2 --time 2024-06-21T00:00Z)
skylut_refuses(map_longitude_no_angle 2 "2d75'E" map -o sky.csv --latitude 48 --longitude "2d75'E"
  --time 2024-06-21T09:00Z)

skylut_refuses(map_directions_unknown 2 "--directions 'utm270'.*utm271, preetham343" map -o sky.csv
  --sun-zenith-deg 45 --directions utm270)
skylut_refuses(map_directions_broken 2 "mine.csv:3: column 'zenith_deg': '1O'" map -o sky.csv --sun-zenith-deg 45
  --directions mine.csv INPUT "mine.csv=zenith_deg,azimuth_deg\\n0,0\\n1O,20\\n")
skylut_refuses(map_directions_for_picture 2 "--directions: is for .csv" map -o sky.exr --sun-zenith-deg 45
  --directions utm271)
skylut_refuses(map_size_for_numbers 2 "--size: is for .exr" map -o sky.csv --sun-zenith-deg 45 --size 64)

skylut_refuses(map_projection_unknown 2 "--projection 'mercator': must be latlong, fisheye, .* or octahedral" map
  -o sky.exr --sun-zenith-deg 45 --projection mercator)
skylut_refuses(map_half_a_cube 2 "--sky half: is for latlong.*must not be given with cube" map -o sky.exr
  --sun-zenith-deg 45 --projection cube --sky half)
skylut_refuses(map_rgb_space_unknown 2 "--rgb-space 'acescc': must be rec709.*did you mean acescg" map -o sky.exr
  --sun-zenith-deg 45 --rgb-space acescc)
skylut_refuses(map_preview_jpeg 2 "sky.jpg.*png" map -o sky.exr --sun-zenith-deg 45 --preview sky.jpg)
skylut_refuses(map_preview_size_alone 2 "--preview-size: needs --preview" map -o sky.exr --sun-zenith-deg 45
  --preview-size 64)
skylut_refuses(map_preview_of_numbers 2 "--preview: is for .exr" map -o sky.csv --sun-zenith-deg 45
  --preview sky.png)
skylut_refuses(map_channels_unknown 2 "--channels 'hsv': must be rgb, xyz, luminance or spectral" map -o sky.exr --sun-zenith-deg 45
  --channels hsv)
skylut_refuses(map_channels_misspelt 2 "--channels 'rgb,spectrall': .*did you mean spectral" map -o sky.exr
  --sun-zenith-deg 45 --channels rgb,spectrall)
skylut_refuses(map_channels_twice 2 "--channels 'rgb,rgb': must have rgb once" map -o sky.exr --sun-zenith-deg 45
  --channels rgb,rgb)
skylut_refuses(map_size_0 2 "--size '0'.*2 to 16384" map -o sky.exr --sun-zenith-deg 45 --size 0)
skylut_refuses(map_size_word 2 "--size '512x256'" map -o sky.exr --sun-zenith-deg 45 --size 512x256)

skylut_refuses(map_sun_kind_unknown 2 "--sun 'dics': must be off, disc or file, did you mean disc" map -o sky.exr
  --sun-zenith-deg 45 --sun dics)
skylut_refuses(map_sun_in_numbers 2 "--sun: is for .exr" map -o sky.csv --sun-zenith-deg 45 --sun disc)
skylut_refuses(map_frame_of_no_series 2 "--frame: needs --suns, --times or --time START/END/STEP" map -o sky.exr
  --sun-zenith-deg 45 --frame 2)
skylut_refuses(map_frame_beyond 2 "--frame 3: the series has 2 frames" map -o sky.exr --suns 45:90,60:100 --frame 3)
skylut_refuses(map_suns_for_numbers 2 "--suns: is for .exr" map -o sky.csv --suns 45:90,60:100)
skylut_refuses(map_steps_for_numbers 2 "--time START/END/STEP: is for .exr" map -o sky.csv --latitude 48 --longitude 2
  --time 2024-06-21T09:00Z/2024-06-21T11:00Z/1h)
skylut_refuses(map_suns_and_angles 2 "--suns: gives the sun, must not be given with --sun-zenith-deg" map -o sky.exr
  --suns 45:90 --sun-zenith-deg 30)
skylut_refuses(map_suns_and_time 2 "--time 2024-06-21T09:00:00Z: gives the sun, must not be given with --suns" map
  -o sky.exr --suns 45:90 --time 2024-06-21T09:00Z --latitude 48 --longitude 2)
skylut_refuses(map_series_without_place 2 "--time .*/1h: needs --latitude and --longitude" map -o sky.exr
  --time 2024-06-21T09:00Z/2024-06-21T11:00Z/1h)
skylut_refuses(map_series_by_night 2 "--time .*: 3 suns, all more than 99 deg from the zenith" map -o sky.exr
  --latitude 48 --longitude 2 --time 2024-12-21T23:00Z/2024-12-22T01:00Z/1h)
skylut_refuses(map_times_broken 2 "mine.csv:2: .*noon" map -o sky.exr --latitude 48 --longitude 2 --times mine.csv
  INPUT "mine.csv=time\nnoon\n")
skylut_refuses(map_series_table_is_a_folder 2 "sky.csv.*directory" map -o sky.exr --suns 45:90 FOLDER sky.csv)

# Options that do not exist, requests that do not fit.
skylut_refuses(map_misspelt 2 "--sun-zenith: unknown option, did you mean --sun-zenith-deg.*skylut map --help" map
  -o sky.csv --sun-zenith 45)
skylut_refuses(map_out_of_memory 1 "ran out of memory|not enough memory" map -o sky.csv
  --sun-zenith-deg 45 --wavelengths-nm 400:700:100 --quality draft --threads 1 MEMORY_KB 42000)
skylut_prints(map_plain_numbers "sun 45:270 deg" map -o SKY.CSV --sun-zenith-deg +4.5e1 --sun-azimuth-deg -90
  --turbidity " 0.1" --wavelengths-nm 400:700:100 --quality draft)
skylut_prints(map_picture_in_capitals "wrote SKY.EXR" map -o SKY.EXR --sun-zenith-deg 45 --size 4
  --wavelengths-nm 400:700:100 --quality draft)
