# describe(VARIABLE): the server manager descriptions, after what they share was pasted. A proxy can build only on what
# stands before it, so the bases of filters come first.
function (describe variable)
  set(here "${PROJECT_SOURCE_DIR}/Plugin")
  set(made "${PROJECT_BINARY_DIR}/Descriptions")
  # What is alike in filters that have different bases is pasted.
  file(READ "${here}/Interpolation.xml.in" INTERPOLATION)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${here}/Interpolation.xml.in")
  set(descriptions)
  foreach (name IN ITEMS SubdivisionAlgorithm RefinementAlgorithm MarkedSubdivisionAlgorithm)
    list(APPEND descriptions "${here}/${name}.xml")
  endforeach ()
  foreach (KIND IN ITEMS Subdivision MarkedSubdivision Refinement)
    configure_file("${here}/SolidOptions.xml.in" "${made}/Solid${KIND}Algorithm.xml" @ONLY)
    list(APPEND descriptions "${made}/Solid${KIND}Algorithm.xml")
  endforeach ()
  foreach (name IN ITEMS AdaptiveSurfaceSubdivision ExtractDimensions MultiDimensionalSubdivision RedGreenRefinement
      SimplicialComplexTopology SubdivisionCageSource SubdivisionDeformation SubdivisionLabelSolid SubdivisionModelSource
      SurfaceSubdivision)
    configure_file("${here}/${name}.xml" "${made}/${name}.xml" @ONLY)
    list(APPEND descriptions "${made}/${name}.xml")
  endforeach ()
  set(${variable} "${descriptions}" PARENT_SCOPE)
endfunction ()
