// The plate with 400 drilled holes of csg_bench.cpp for POV-Ray: the same shapes, camera and light.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 1 }
background { rgb <0.8, 0.85, 0.9> }

// Right-handed as ours, and as wide as it is high: 0.6 radians.
camera {
  location <9, 22, 27>
  sky y
  up y
  right -x
  angle degrees(0.6)
  look_at <0, 0, 0>
}

light_source { <-20, 40, 15> rgb 1 }

difference {
  box { <-10, -0.5, -10>, <10, 0.5, 10> }
  #for (I, 0, 19)
    #for (J, 0, 19)
      cylinder { <I - 9.5, -1, J - 9.5>, <I - 9.5, 1, J - 9.5>, 0.35 }
    #end
  #end
  texture {
    pigment { rgb <0.5, 0.6, 0.7> }
    finish { ambient rgb 0.2 diffuse 1 }
  }
}
