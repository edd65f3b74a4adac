// assets/scenes/fig10.gltf for POV-Ray: the same shapes, camera, lights and materials.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 1 }
background { rgb <0.8, 0.8, 0.78> }

// glTF is right-handed, which the negative `right` makes POV-Ray. The view is 0.6 radians high.
camera {
  location <-0.9, 7.4, 12.4>
  sky y
  up y
  right -x
  angle degrees(0.6)
  look_at <-0.05, -0.1, 0>
}

// POV-Ray's lights have one colour for both diffuse and specular light: here the diffuse one. The
// other is 1.4 times as strong, which goes into the materials' specular factor.
light_source { <3, 9, 7> rgb <0.74, 0.7, 0.64> }
light_source { <-7, 8, 4> rgb <0.32, 0.36, 0.4> }

#declare Ambient = rgb <0.22, 0.23, 0.26>;
#declare BlueGrey = texture {
  pigment { rgb <0.16, 0.24, 0.33> }
  finish { ambient Ambient diffuse 1 specular 1.4 * 0.25 roughness 1 / 40 }
}
#declare Orange = texture {
  pigment { rgb <0.72, 0.24, 0.05> }
  finish { ambient Ambient diffuse 1 specular 1.4 * 0.3 roughness 1 / 50 }
}
#declare Paper = texture {
  pigment { rgb <0.78, 0.77, 0.74> }
  finish { ambient Ambient diffuse 1 }
}

#declare Box = box { -1, 1 texture { BlueGrey } }
#declare Sphere = sphere { 0, 1.3 texture { Orange } }

union { object { Box } object { Sphere } rotate 32 * y translate <-2.55, 0, 1.75> }
intersection { object { Box } object { Sphere } rotate 32 * y }
difference { object { Box } object { Sphere } rotate 32 * y translate <2.55, 0, -1.75> }
plane { y, -1.3 texture { Paper } }
