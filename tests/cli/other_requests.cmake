# Wrong requests to the other commands.
skylut_prints(profiles "ussa1976" profile list)

skylut_refuses(fit_without_file 2 "FILE is required" fit)
skylut_refuses(fit_missing_file 2 "sky.csv" fit sky.csv)
skylut_refuses(fit_broken_csv 2 "sky.csv:3" fit sky.csv
  INPUT "sky.csv=zenith_deg,gamma_deg,Y,x,y\\n0,45,1,0.3,0.3\\n10,forty,1,0.3,0.3\\n")
skylut_refuses(fit_missing_column 2 "sky.csv.*x" fit sky.csv --sun-zenith-deg 45
  INPUT "sky.csv=zenith_deg,gamma_deg,Y,y\\n0,45,1,0.3\\n")
skylut_refuses(fit_too_few_directions 2 "6" fit sky.csv --sun-zenith-deg 45
  INPUT "sky.csv=zenith_deg,gamma_deg,Y,x,y\\n0,45,1,0.3,0.3\\n")
skylut_refuses(compare_without_against 2 "--against is required" compare out)
skylut_refuses(compare_unknown_model 2 "hosek" compare out --against hosek FOLDER out)
skylut_refuses(compare_missing_table 2 "out" compare out --against preetham1999)
skylut_refuses(compare_broken_table 2 "table.csv" compare out --against preetham1999 INPUT "out/table.csv=altitude_km\\n0\\n")
skylut_prints(profile_gases "water_vapour +1.416 cm" profile show ussa1976 --water-cm 1.416)
skylut_prints(profile_no2 "nitrogen_dioxide +0.204 DU" profile show tropical --no2-du 0.204)
skylut_refuses(profile_water 2 "precipitable water 21 cm: must lie within 0 to 20 cm" profile show tropical --water-cm 21)
skylut_refuses(profile_no2_absent 2 "utm2005 holds no nitrogen_dioxide" profile show utm2005 --no2-du 0.2)
skylut_refuses(profile_unknown 2 "mars" profile show mars)
skylut_refuses(solve_missing_file 2 "case.json" solve case.json)
skylut_refuses(solve_unknown_limit 2 "quality limit .step.: must be one of" solve case.json --limit step=1)
skylut_refuses(solve_limit_out_of_range 2 "tolerance 1: must be a number within" solve case.json --limit tolerance=1)
skylut_refuses(solve_broken_json 2 "case.json" solve case.json INPUT "case.json={\\\"layers\\\": [")
