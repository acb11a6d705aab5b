# Wrong requests to `skylut eval`.
set(SKYLUT_EVAL_SKY eval preetham1999 -o sky.csv --turbidity 3 --sun-zenith-deg 60)
skylut_refuses(eval_unknown_source 2 "'preetham1998': must be .* preetham1999.*did you mean preetham1999" eval
  preetham1998 -o sky.csv --turbidity 3 --sun-zenith-deg 60)
skylut_refuses(eval_output_png 2 "sky.png.*csv or .exr" eval preetham1999 -o sky.png --sun-zenith-deg 60)
skylut_refuses(eval_no_sun 2 "no sun: give --sun-zenith-deg" eval preetham1999 -o sky.csv --turbidity 3)
skylut_refuses(eval_kind_alone 2 "--turbidity-kind: needs --turbidity" eval preetham1999 -o sky.csv
  --sun-zenith-deg 60 --turbidity-kind aod500)
skylut_refuses(eval_turbidity_outside 2 "turbidity .preetham-t. 7 .2 to 6.: .*--extrapolate insists" eval
  preetham1999 -o sky.csv --turbidity 7 --sun-zenith-deg 60)
skylut_refuses(eval_altitude_outside 2 "altitude 3 km .0 to 0 km.: outside" ${SKYLUT_EVAL_SKY} --altitude-km 3)
skylut_refuses(eval_sun_outside 2 "sun zenith angle 91 deg .0 to 90 deg.: outside" eval preetham1999 -o sky.csv
  --turbidity 3 --sun-zenith-deg 91)
skylut_refuses(eval_albedo_without_axis 2 "--albedo 0.3: preetham1999 has one ground only" ${SKYLUT_EVAL_SKY}
  --albedo 0.3)
skylut_refuses(eval_spectra_of_colours 2 "--spectral: preetham1999 knows Y, x, y only" ${SKYLUT_EVAL_SKY} --spectral)
skylut_refuses(eval_spectral_channels_of_colours 2 "--channels spectral: preetham1999 knows Y, x, y only" eval
  preetham1999 -o sky.exr --turbidity 3 --sun-zenith-deg 60 --channels spectral)
skylut_refuses(eval_interpolation_of_no_table 2 "--interpolation: is for tables, preetham1999 is none"
  ${SKYLUT_EVAL_SKY} --interpolation blend)
skylut_refuses(eval_directions_of_picture 2 "--directions: is for .csv files" eval preetham1999 -o sky.exr
  --turbidity 3 --sun-zenith-deg 60 --directions utm271)
skylut_refuses(eval_size_of_csv 2 "--size: is for .exr files" ${SKYLUT_EVAL_SKY} --size 8)
skylut_refuses(eval_view_below_horizon 2 "view zenith angle 91 deg: must lie within 0 to 90 deg" ${SKYLUT_EVAL_SKY}
  --directions low.csv INPUT "low.csv=zenith_deg,azimuth_deg\n91,0\n")
skylut_refuses(eval_picture_full 1 "sky.exr: cannot write: No space left" eval preetham1999 -o sky.exr
  --turbidity 3 --sun-zenith-deg 60 --size 4 LINK sky.exr=/dev/full)
skylut_refuses(eval_table_without_columns 2 "table.csv: no column .altitude_km." eval table.csv -o sky.csv
  --sun-zenith-deg 60 INPUT "table.csv=a,b\n1,2\n")
skylut_refuses(eval_default_turbidity_outside 2 "turbidity .preetham-t.*without --turbidity it is aod500 0.1" eval
  preetham1999 -o sky.csv --sun-zenith-deg 60)
skylut_refuses(eval_json_of_something_else 2 "other.json.*must be a model file" eval other.json -o sky.csv
  --sun-zenith-deg 60 INPUT "other.json={\"altitude_km\": 3}\n")
