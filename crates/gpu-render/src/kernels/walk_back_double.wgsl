// Compiled from walk_back.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 94ebea24f75660c7
// result: 1c69f077947f97de

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) room_0 : u32,
    @align(4) depth_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(5) @group(0) var<storage, read> input_0 : array<u32>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

@binding(4) @group(0) var<storage, read> scene_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_0 : array<f64>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

struct s_bwdCallableCtx_sqrt_0
{
     _S1 : f32,
};

struct DiffPair_float_0
{
     primal_0 : f32,
     differential_0 : f32,
};

fn _d_sqrt_0( dpx_0 : ptr<function, DiffPair_float_0>,  dOut_0 : f32)
{
    var _S2 : f32 = 0.5f / sqrt(max(1.00000001168609742e-07f, (*dpx_0).primal_0)) * dOut_0;
    (*dpx_0).primal_0 = (*dpx_0).primal_0;
    (*dpx_0).differential_0 = _S2;
    return;
}

fn s_bwdProp_sqrt_0( ctx_0 : s_bwdCallableCtx_sqrt_0,  d_x_0 : ptr<function, f32>,  d_out_0 : f32)
{
    var _S3 : DiffPair_float_0;
    _S3.primal_0 = ctx_0._S1;
    _d_sqrt_0(&(_S3), d_out_0);
    (*d_x_0) = _S3.differential_0;
    return;
}

struct Tuple_0
{
     value0_0 : f32,
};

fn s_apply_length_0( x_0 : vec3<f32>) -> Tuple_0
{
    var _S4 : Tuple_0 = Tuple_0( length(x_0) );
    return _S4;
}

struct s_bwdCallableCtx_length_0
{
     _S5 : vec3<f32>,
};

struct DiffPair_vectorx3Cfloatx2C3x3E_0
{
     primal_0 : vec3<f32>,
     differential_0 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_length_impl_0
{
     value0_1 : vec3<f32>,
};

struct s_bwdCallableCtx_length_impl_0
{
     value0_2 : s_paramCtx_s_bwdCallableCtx_length_impl_0,
};

fn s_bwdProp_length_impl_0( _S6 : s_bwdCallableCtx_length_impl_0,  _S7 : ptr<function, vec3<f32>>,  _S8 : f32)
{
    var _S9 : f32 = _S6.value0_2.value0_1[i32(0)];
    var _S10 : f32 = _S6.value0_2.value0_1[i32(1)];
    var _S11 : f32 = _S6.value0_2.value0_1[i32(2)];
    var _S12 : s_bwdCallableCtx_sqrt_0;
    _S12._S1 = _S9 * _S9 + _S10 * _S10 + _S11 * _S11;
    var _S13 : f32 = 0.0f;
    s_bwdProp_sqrt_0(_S12, &(_S13), _S8);
    var _S14 : f32 = _S6.value0_2.value0_1[i32(2)] * _S13;
    var _S15 : f32 = _S14 + _S14;
    var _S16 : f32 = _S6.value0_2.value0_1[i32(1)] * _S13;
    var _S17 : f32 = _S16 + _S16;
    var _S18 : f32 = _S6.value0_2.value0_1[i32(0)] * _S13;
    var _S19 : f32 = _S18 + _S18;
    var _S20 : vec3<f32> = vec3<f32>(0.0f);
    _S20[i32(2)] = _S15;
    _S20[i32(1)] = _S17;
    _S20[i32(0)] = _S19;
    (*_S7) = _S20;
    return;
}

fn _S21( _S22 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S23 : f32)
{
    var _S24 : s_paramCtx_s_bwdCallableCtx_length_impl_0;
    _S24.value0_1 = (*_S22).primal_0;
    var _S25 : s_bwdCallableCtx_length_impl_0 = s_bwdCallableCtx_length_impl_0( _S24 );
    var _S26 : vec3<f32> = (*_S22).differential_0;
    s_bwdProp_length_impl_0(_S25, &(_S26), _S23);
    (*_S22).differential_0 = _S26;
    return;
}

fn s_bwdProp_length_0( ctx_1 : s_bwdCallableCtx_length_0,  d_x_1 : ptr<function, vec3<f32>>,  d_out_1 : f32)
{
    var _S27 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S27.primal_0 = ctx_1._S5;
    _S21(&(_S27), d_out_1);
    (*d_x_1) = _S27.differential_0;
    return;
}

struct s_bwdCallableCtx_cross_0
{
     _S28 : vec3<f32>,
     _S29 : vec3<f32>,
};

fn _d_cross_0( a_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  b_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dOut_1 : vec3<f32>)
{
    var _S30 : f32 = dOut_1.y;
    var _S31 : f32 = dOut_1.z;
    var _S32 : f32 = dOut_1.x;
    var _S33 : f32 = (*a_0).primal_0.z * _S30 + - (*a_0).primal_0.y * _S31;
    var _S34 : f32 = - (*a_0).primal_0.z * _S32 + (*a_0).primal_0.x * _S31;
    var _S35 : f32 = (*a_0).primal_0.y * _S32 + - (*a_0).primal_0.x * _S30;
    var _S36 : vec3<f32> = vec3<f32>(- (*b_0).primal_0.z * _S30 + (*b_0).primal_0.y * _S31, (*b_0).primal_0.z * _S32 + - (*b_0).primal_0.x * _S31, - (*b_0).primal_0.y * _S32 + (*b_0).primal_0.x * _S30);
    (*a_0).primal_0 = (*a_0).primal_0;
    (*a_0).differential_0 = _S36;
    var _S37 : vec3<f32> = vec3<f32>(_S33, _S34, _S35);
    (*b_0).primal_0 = (*b_0).primal_0;
    (*b_0).differential_0 = _S37;
    return;
}

fn s_bwdProp_cross_0( ctx_2 : s_bwdCallableCtx_cross_0,  d_left_0 : ptr<function, vec3<f32>>,  d_right_0 : ptr<function, vec3<f32>>,  d_out_2 : vec3<f32>)
{
    var _S38 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S38.primal_0 = ctx_2._S28;
    var _S39 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S39.primal_0 = ctx_2._S29;
    _d_cross_0(&(_S38), &(_S39), d_out_2);
    (*d_left_0) = _S38.differential_0;
    (*d_right_0) = _S39.differential_0;
    return;
}

struct Tuple_1
{
     value0_3 : vec3<f32>,
};

fn s_apply_normalize_0( x_1 : vec3<f32>) -> Tuple_1
{
    var _S40 : Tuple_1 = Tuple_1( normalize(x_1) );
    return _S40;
}

struct s_bwdCallableCtx_normalize_0
{
     _S41 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_normalize_impl_0
{
     value0_4 : vec3<f32>,
};

struct s_bwdCallableCtx_normalize_impl_0
{
     value0_5 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0,
};

fn s_bwdProp_normalize_impl_0( _S42 : s_bwdCallableCtx_normalize_impl_0,  _S43 : ptr<function, vec3<f32>>,  _S44 : vec3<f32>)
{
    var _S45 : Tuple_0 = s_apply_length_0(_S42.value0_5.value0_4);
    var _S46 : s_bwdCallableCtx_length_0;
    _S46._S5 = _S42.value0_5.value0_4;
    var _S47 : vec3<f32> = _S42.value0_5.value0_4 * _S44;
    var _S48 : vec3<f32> = vec3<f32>((1.0f / _S45.value0_0)) * _S44;
    var _S49 : f32 = - ((_S47[i32(0)] + _S47[i32(1)] + _S47[i32(2)]) / (_S45.value0_0 * _S45.value0_0));
    var _S50 : vec3<f32> = vec3<f32>(0.0f);
    s_bwdProp_length_0(_S46, &(_S50), _S49);
    (*_S43) = _S48 + _S50;
    return;
}

fn _S51( _S52 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S53 : vec3<f32>)
{
    var _S54 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0;
    _S54.value0_4 = (*_S52).primal_0;
    var _S55 : s_bwdCallableCtx_normalize_impl_0 = s_bwdCallableCtx_normalize_impl_0( _S54 );
    var _S56 : vec3<f32> = (*_S52).differential_0;
    s_bwdProp_normalize_impl_0(_S55, &(_S56), _S53);
    (*_S52).differential_0 = _S56;
    return;
}

fn s_bwdProp_normalize_0( ctx_3 : s_bwdCallableCtx_normalize_0,  d_x_2 : ptr<function, vec3<f32>>,  d_out_3 : vec3<f32>)
{
    var _S57 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S57.primal_0 = ctx_3._S41;
    _S51(&(_S57), d_out_3);
    (*d_x_2) = _S57.differential_0;
    return;
}

struct Tuple_2
{
     value0_6 : f32,
};

fn s_apply_dot_0( x_2 : vec3<f32>,  y_0 : vec3<f32>) -> Tuple_2
{
    var _S58 : Tuple_2 = Tuple_2( dot(x_2, y_0) );
    return _S58;
}

struct s_bwdCallableCtx_dot_0
{
     _S59 : vec3<f32>,
     _S60 : vec3<f32>,
};

fn _d_dot_0( dpx_1 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dpy_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dOut_2 : f32)
{
    var x_d_result_0 : vec3<f32>;
    x_d_result_0[i32(0)] = (*dpy_0).primal_0[i32(0)] * dOut_2;
    var y_d_result_0 : vec3<f32>;
    y_d_result_0[i32(0)] = (*dpx_1).primal_0[i32(0)] * dOut_2;
    x_d_result_0[i32(1)] = (*dpy_0).primal_0[i32(1)] * dOut_2;
    y_d_result_0[i32(1)] = (*dpx_1).primal_0[i32(1)] * dOut_2;
    x_d_result_0[i32(2)] = (*dpy_0).primal_0[i32(2)] * dOut_2;
    y_d_result_0[i32(2)] = (*dpx_1).primal_0[i32(2)] * dOut_2;
    (*dpx_1).primal_0 = (*dpx_1).primal_0;
    (*dpx_1).differential_0 = x_d_result_0;
    (*dpy_0).primal_0 = (*dpy_0).primal_0;
    (*dpy_0).differential_0 = y_d_result_0;
    return;
}

fn s_bwdProp_dot_0( ctx_4 : s_bwdCallableCtx_dot_0,  d_x_3 : ptr<function, vec3<f32>>,  d_y_0 : ptr<function, vec3<f32>>,  d_out_4 : f32)
{
    var _S61 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S61.primal_0 = ctx_4._S59;
    var _S62 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S62.primal_0 = ctx_4._S60;
    _d_dot_0(&(_S61), &(_S62), d_out_4);
    (*d_x_3) = _S61.differential_0;
    (*d_y_0) = _S62.differential_0;
    return;
}

struct s_bwdCallableCtx_max_0
{
     _S63 : f32,
     _S64 : f32,
};

fn _d_max_0( dpx_2 : ptr<function, DiffPair_float_0>,  dpy_1 : ptr<function, DiffPair_float_0>,  dOut_3 : f32)
{
    var _S65 : DiffPair_float_0 = (*dpx_2);
    var _S66 : f32;
    if(((*dpx_2).primal_0) > ((*dpy_1).primal_0))
    {
        _S66 = dOut_3;
    }
    else
    {
        if(((*dpx_2).primal_0) < ((*dpy_1).primal_0))
        {
            _S66 = 0.0f;
        }
        else
        {
            _S66 = 0.5f * dOut_3;
        }
    }
    (*dpx_2).primal_0 = _S65.primal_0;
    (*dpx_2).differential_0 = _S66;
    var _S67 : DiffPair_float_0 = (*dpy_1);
    if(((*dpy_1).primal_0) > (_S65.primal_0))
    {
        _S66 = dOut_3;
    }
    else
    {
        if(((*dpy_1).primal_0) < ((*dpx_2).primal_0))
        {
            _S66 = 0.0f;
        }
        else
        {
            _S66 = 0.5f * dOut_3;
        }
    }
    (*dpy_1).primal_0 = _S67.primal_0;
    (*dpy_1).differential_0 = _S66;
    return;
}

fn s_bwdProp_max_0( ctx_5 : s_bwdCallableCtx_max_0,  d_x_4 : ptr<function, f32>,  d_y_1 : ptr<function, f32>,  d_out_5 : f32)
{
    var _S68 : DiffPair_float_0;
    _S68.primal_0 = ctx_5._S63;
    var _S69 : DiffPair_float_0;
    _S69.primal_0 = ctx_5._S64;
    _d_max_0(&(_S68), &(_S69), d_out_5);
    (*d_x_4) = _S68.differential_0;
    (*d_y_1) = _S69.differential_0;
    return;
}

struct Tuple_3
{
     value0_7 : f32,
};

fn s_apply_abs_0( x_3 : f32) -> Tuple_3
{
    var _S70 : Tuple_3 = Tuple_3( abs(x_3) );
    return _S70;
}

struct s_bwdCallableCtx_abs_0
{
     _S71 : f32,
};

fn _d_abs_0( dpx_3 : ptr<function, DiffPair_float_0>,  dOut_4 : f32)
{
    var _S72 : f32 = select(select(-1.0f, 0.0f, ((*dpx_3).primal_0) == 0.0f), 1.0f, ((*dpx_3).primal_0) > 0.0f) * dOut_4;
    (*dpx_3).primal_0 = (*dpx_3).primal_0;
    (*dpx_3).differential_0 = _S72;
    return;
}

fn s_bwdProp_abs_0( ctx_6 : s_bwdCallableCtx_abs_0,  d_x_5 : ptr<function, f32>,  d_out_6 : f32)
{
    var _S73 : DiffPair_float_0;
    _S73.primal_0 = ctx_6._S71;
    _d_abs_0(&(_S73), d_out_6);
    (*d_x_5) = _S73.differential_0;
    return;
}

struct Axes_0
{
     s_0 : vec3<f32>,
     t_0 : vec3<f32>,
     n_0 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_axes_around_0
{
     value0_8 : vec3<f32>,
     value1_0 : bool,
};

struct s_bwdCallableCtx_axes_around_0
{
     value0_9 : s_paramCtx_s_bwdCallableCtx_axes_around_0,
};

fn s_bwdProp_axes_around_0( _S74 : s_bwdCallableCtx_axes_around_0,  _S75 : ptr<function, vec3<f32>>,  _S76 : Axes_0)
{
    var _S77 : f32 = _S74.value0_9.value0_8.z;
    var sign_0 : f32;
    if(_S77 < -0.00000999999974738f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var _S78 : f32 = sign_0 + _S77;
    var a_1 : f32 = -1.0f / _S78;
    var _S79 : f32 = _S78 * _S78;
    var _S80 : f32 = _S74.value0_9.value0_8.x;
    var _S81 : f32 = _S74.value0_9.value0_8.y;
    var _S82 : f32 = _S80 * _S81;
    var _S83 : f32 = sign_0 * _S80;
    var _S84 : f32 = _S83 * _S80;
    var _S85 : f32 = - sign_0;
    var _S86 : f32 = _S81 * _S81;
    var _S87 : f32 = _S81 * (a_1 * _S76.t_0[i32(1)]);
    var _S88 : f32 = a_1 * _S76.s_0[i32(0)];
    var _S89 : f32 = _S76.t_0[i32(0)] + sign_0 * _S76.s_0[i32(1)];
    var _S90 : f32 = a_1 * _S89;
    var _S91 : vec3<f32> = vec3<f32>(_S85 * _S76.s_0[i32(2)] + _S83 * _S88 + sign_0 * (_S80 * _S88) + _S81 * _S90, - _S76.t_0[i32(2)] + _S87 + _S87 + _S80 * _S90, 0.0f) + vec3<f32>(0.0f, 0.0f, -1.0f * - ((_S86 * _S76.t_0[i32(1)] + _S84 * _S76.s_0[i32(0)] + _S82 * _S89) / _S79));
    var _S92 : vec3<f32>;
    if(_S74.value0_9.value1_0)
    {
        _S92 = _S76.n_0 + _S91;
    }
    else
    {
        _S92 = (vec3<f32>(0) - _S76.n_0) + _S91;
    }
    (*_S75) = _S92;
    return;
}

fn _S93( _S94 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S95 : bool,  _S96 : Axes_0)
{
    var _S97 : s_paramCtx_s_bwdCallableCtx_axes_around_0;
    _S97.value0_8 = (*_S94).primal_0;
    _S97.value1_0 = _S95;
    var _S98 : s_bwdCallableCtx_axes_around_0 = s_bwdCallableCtx_axes_around_0( _S97 );
    var _S99 : vec3<f32> = (*_S94).differential_0;
    s_bwdProp_axes_around_0(_S98, &(_S99), _S96);
    (*_S94).differential_0 = _S99;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_axes_along_0
{
     value0_10 : vec3<f32>,
     value1_1 : vec3<f32>,
     value2_0 : bool,
};

struct s_bwdCallableCtx_axes_along_0
{
     value0_11 : s_paramCtx_s_bwdCallableCtx_axes_along_0,
};

fn s_bwdProp_axes_along_0( _S100 : s_bwdCallableCtx_axes_along_0,  _S101 : ptr<function, vec3<f32>>,  _S102 : ptr<function, vec3<f32>>,  _S103 : Axes_0)
{
    var _S104 : vec3<f32> = vec3<f32>(s_apply_dot_0(_S100.value0_11.value0_10, _S100.value0_11.value1_1).value0_6);
    var _S105 : s_bwdCallableCtx_dot_0;
    _S105._S59 = _S100.value0_11.value0_10;
    _S105._S60 = _S100.value0_11.value1_1;
    var _S106 : vec3<f32> = _S100.value0_11.value1_1 - _S100.value0_11.value0_10 * _S104;
    var _S107 : Tuple_1 = s_apply_normalize_0(_S106);
    var _S108 : s_bwdCallableCtx_normalize_0;
    _S108._S41 = _S106;
    var _S109 : s_bwdCallableCtx_cross_0;
    _S109._S28 = _S100.value0_11.value0_10;
    _S109._S29 = _S107.value0_3;
    var _S110 : vec3<f32> = vec3<f32>(0.0f);
    var _S111 : vec3<f32> = _S110;
    var _S112 : vec3<f32> = _S110;
    s_bwdProp_cross_0(_S109, &(_S111), &(_S112), _S103.t_0);
    var _S113 : vec3<f32> = _S103.s_0 + _S112;
    var _S114 : vec3<f32> = _S110;
    s_bwdProp_normalize_0(_S108, &(_S114), _S113);
    var _S115 : vec3<f32> = (vec3<f32>(0) - _S114);
    var _S116 : vec3<f32> = _S100.value0_11.value0_10 * _S115;
    var _S117 : vec3<f32> = _S104 * _S115;
    var _S118 : f32 = _S116[i32(0)] + _S116[i32(1)] + _S116[i32(2)];
    var _S119 : vec3<f32> = _S110;
    var _S120 : vec3<f32> = _S110;
    s_bwdProp_dot_0(_S105, &(_S119), &(_S120), _S118);
    var _S121 : vec3<f32> = _S111 + _S117 + _S119;
    var _S122 : vec3<f32> = _S114 + _S120;
    var _S123 : vec3<f32>;
    if(_S100.value0_11.value2_0)
    {
        _S123 = _S103.n_0 + _S121;
    }
    else
    {
        _S123 = (vec3<f32>(0) - _S103.n_0) + _S121;
    }
    (*_S101) = _S123;
    (*_S102) = _S122;
    return;
}

fn _S124( _S125 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S126 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S127 : bool,  _S128 : Axes_0)
{
    var _S129 : s_paramCtx_s_bwdCallableCtx_axes_along_0;
    _S129.value0_10 = (*_S125).primal_0;
    _S129.value1_1 = (*_S126).primal_0;
    _S129.value2_0 = _S127;
    var _S130 : s_bwdCallableCtx_axes_along_0 = s_bwdCallableCtx_axes_along_0( _S129 );
    var _S131 : vec3<f32> = (*_S125).differential_0;
    var _S132 : vec3<f32> = (*_S126).differential_0;
    s_bwdProp_axes_along_0(_S130, &(_S131), &(_S132), _S128);
    (*_S125).differential_0 = _S131;
    (*_S126).differential_0 = _S132;
    return;
}

struct DiffPair_Axes_0
{
     primal_0 : Axes_0,
     differential_0 : Axes_0,
};

struct s_paramCtx_s_bwdCallableCtx_towards_viewer_0
{
     value0_12 : Axes_0,
     value1_2 : vec3<f32>,
};

struct s_bwdCallableCtx_towards_viewer_0
{
     value0_13 : s_paramCtx_s_bwdCallableCtx_towards_viewer_0,
};

struct Tuple_4
{
     value0_14 : vec3<f32>,
};

fn s_apply_to_local_0( _S133 : Axes_0,  _S134 : vec3<f32>) -> Tuple_4
{
    var _S135 : Tuple_4;
    _S135.value0_14 = vec3<f32>(s_apply_dot_0(_S133.s_0, _S134).value0_6, s_apply_dot_0(_S133.t_0, _S134).value0_6, s_apply_dot_0(_S133.n_0, _S134).value0_6);
    return _S135;
}

struct s_paramCtx_s_bwdCallableCtx_to_local_0
{
     value0_15 : Axes_0,
     value1_3 : vec3<f32>,
};

struct s_bwdCallableCtx_to_local_0
{
     value0_16 : s_paramCtx_s_bwdCallableCtx_to_local_0,
};

fn Axes_x24_syn_dzero_0() -> Axes_0
{
    var result_0 : Axes_0;
    var _S136 : vec3<f32> = vec3<f32>(0.0f);
    result_0.s_0 = _S136;
    result_0.t_0 = _S136;
    result_0.n_0 = _S136;
    return result_0;
}

fn Axes_x24_syn_dadd_0( SLANG_anonymous_0_0 : Axes_0,  SLANG_anonymous_1_0 : Axes_0) -> Axes_0
{
    var result_1 : Axes_0;
    result_1.s_0 = SLANG_anonymous_0_0.s_0 + SLANG_anonymous_1_0.s_0;
    result_1.t_0 = SLANG_anonymous_0_0.t_0 + SLANG_anonymous_1_0.t_0;
    result_1.n_0 = SLANG_anonymous_0_0.n_0 + SLANG_anonymous_1_0.n_0;
    return result_1;
}

fn s_bwdProp_to_local_0( _S137 : s_bwdCallableCtx_to_local_0,  _S138 : ptr<function, Axes_0>,  _S139 : ptr<function, vec3<f32>>,  _S140 : vec3<f32>)
{
    var _S141 : s_bwdCallableCtx_dot_0;
    _S141._S59 = _S137.value0_16.value0_15.s_0;
    _S141._S60 = _S137.value0_16.value1_3;
    var _S142 : s_bwdCallableCtx_dot_0;
    _S142._S59 = _S137.value0_16.value0_15.t_0;
    _S142._S60 = _S137.value0_16.value1_3;
    var _S143 : s_bwdCallableCtx_dot_0;
    _S143._S59 = _S137.value0_16.value0_15.n_0;
    _S143._S60 = _S137.value0_16.value1_3;
    var _S144 : Axes_0 = Axes_x24_syn_dzero_0();
    var _S145 : vec3<f32> = vec3<f32>(0.0f);
    var _S146 : vec3<f32> = _S145;
    var _S147 : vec3<f32> = _S145;
    s_bwdProp_dot_0(_S143, &(_S146), &(_S147), _S140[i32(2)]);
    var _S148 : vec3<f32> = _S145;
    var _S149 : vec3<f32> = _S145;
    s_bwdProp_dot_0(_S142, &(_S148), &(_S149), _S140[i32(1)]);
    var _S150 : vec3<f32> = _S145;
    var _S151 : vec3<f32> = _S145;
    s_bwdProp_dot_0(_S141, &(_S150), &(_S151), _S140[i32(0)]);
    var _S152 : vec3<f32> = _S147 + _S149 + _S151;
    var _S153 : Axes_0 = _S144;
    _S153.n_0 = _S146;
    _S153.t_0 = _S148;
    _S153.s_0 = _S150;
    (*_S138) = Axes_x24_syn_dadd_0(_S144, _S153);
    (*_S139) = _S152;
    return;
}

fn s_bwdProp_towards_viewer_0( _S154 : s_bwdCallableCtx_towards_viewer_0,  _S155 : ptr<function, Axes_0>,  _S156 : ptr<function, vec3<f32>>,  _S157 : vec3<f32>)
{
    var _S158 : Tuple_4 = s_apply_to_local_0(_S154.value0_13.value0_12, _S154.value0_13.value1_2);
    var _S159 : s_paramCtx_s_bwdCallableCtx_to_local_0;
    _S159.value0_15 = _S154.value0_13.value0_12;
    _S159.value1_3 = _S154.value0_13.value1_2;
    var _S160 : s_bwdCallableCtx_to_local_0 = s_bwdCallableCtx_to_local_0( _S159 );
    var _S161 : f32 = (vec3<f32>(0) - _S158.value0_14).z;
    var _S162 : Tuple_3 = s_apply_abs_0(_S161);
    var _S163 : s_bwdCallableCtx_abs_0;
    _S163._S71 = _S161;
    var _S164 : s_bwdCallableCtx_max_0;
    _S164._S63 = _S162.value0_7;
    _S164._S64 = 9.999999960041972e-13f;
    var _S165 : Axes_0 = Axes_x24_syn_dzero_0();
    var _S166 : f32 = 0.0f;
    var _S167 : f32 = 0.0f;
    s_bwdProp_max_0(_S164, &(_S166), &(_S167), _S157[i32(2)]);
    var _S168 : f32 = 0.0f;
    s_bwdProp_abs_0(_S163, &(_S168), _S166);
    var _S169 : vec3<f32> = (vec3<f32>(0) - vec3<f32>(_S157[i32(0)], _S157[i32(1)], _S168));
    var _S170 : vec3<f32> = vec3<f32>(0.0f);
    var _S171 : Axes_0;
    _S171.s_0 = _S170;
    _S171.t_0 = _S170;
    _S171.n_0 = _S170;
    var _S172 : vec3<f32> = _S170;
    s_bwdProp_to_local_0(_S160, &(_S171), &(_S172), _S169);
    (*_S155) = Axes_x24_syn_dadd_0(_S171, _S165);
    (*_S156) = _S172;
    return;
}

fn _S173( _S174 : ptr<function, DiffPair_Axes_0>,  _S175 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S176 : vec3<f32>)
{
    var _S177 : s_paramCtx_s_bwdCallableCtx_towards_viewer_0;
    _S177.value0_12 = (*_S174).primal_0;
    _S177.value1_2 = (*_S175).primal_0;
    var _S178 : s_bwdCallableCtx_towards_viewer_0 = s_bwdCallableCtx_towards_viewer_0( _S177 );
    var _S179 : Axes_0 = (*_S174).differential_0;
    var _S180 : vec3<f32> = (*_S175).differential_0;
    s_bwdProp_towards_viewer_0(_S178, &(_S179), &(_S180), _S176);
    (*_S174).differential_0 = _S179;
    (*_S175).differential_0 = _S180;
    return;
}

fn path_word_0( path_0 : u32,  which_0 : u32) -> u32
{
    return paths_0[which_0 * launch_0.room_0 + path_0];
}

fn path_vector_0( path_1 : u32,  which_1 : ptr<function, u32>) -> vec3<f32>
{
    var _S181 : u32 = (*which_1) + u32(3);
    (*which_1) = _S181;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_1, _S181 - u32(3)), path_word_0(path_1, _S181 - u32(2)), path_word_0(path_1, _S181 - u32(1))))));
}

fn path_vector_1( path_2 : u32,  which_2 : ptr<function, u32>) -> vec3<f32>
{
    var _S182 : u32 = (*which_2) + u32(3);
    (*which_2) = _S182;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_2, _S182 - u32(3)), path_word_0(path_2, _S182 - u32(2)), path_word_0(path_2, _S182 - u32(1))))));
}

fn path_changing_0( path_3 : u32,  which_3 : ptr<function, u32>) -> vec3<f32>
{
    var value_0 : vec3<f32> = path_vector_1(path_3, &((*which_3)));
    return value_0;
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
};

fn exact_place_0( triangle_1 : u32,  v_1 : f64,  w_1 : f64) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_0 = triangle_1;
    var _S183 : f32 = f32(v_1);
    place_0.v_0 = _S183;
    var _S184 : f32 = f32(w_1);
    place_0.w_0 = _S184;
    place_0.v_rest_0 = f32(v_1 - f64(_S183));
    place_0.w_rest_0 = f32(w_1 - f64(_S184));
    return place_0;
}

fn path_place_0( path_4 : u32,  which_4 : ptr<function, u32>) -> Place_0
{
    var _S185 : u32 = (*which_4) + u32(5);
    (*which_4) = _S185;
    return exact_place_0(path_word_0(path_4, _S185 - u32(5)), f64((bitcast<f32>((path_word_0(path_4, _S185 - u32(4)))))) + f64((bitcast<f32>((path_word_0(path_4, _S185 - u32(2)))))), f64((bitcast<f32>((path_word_0(path_4, _S185 - u32(3)))))) + f64((bitcast<f32>((path_word_0(path_4, _S185 - u32(1)))))));
}

struct ByRay_0
{
     drift_0 : vec3<f32>,
     direction_0 : vec3<f32>,
};

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_1 : vec3<f32>,
     place_1 : Place_0,
     key_0 : vec2<u32>,
     adjoint_0 : vec3<f32>,
     distance_0 : f32,
     by_ray_0 : ByRay_0,
};

fn load_0( number_of_path_0 : u32) -> Path_0
{
    var at_0 : u32 = u32(1);
    var path_5 : Path_0;
    var _S186 : vec3<f32> = path_vector_0(number_of_path_0, &(at_0));
    path_5.adjoint_0 = _S186;
    path_5.distance_0 = 0.0f;
    var _S187 : vec3<f32> = vec3<f32>(0.0f);
    path_5.by_ray_0.direction_0 = _S187;
    path_5.by_ray_0.drift_0 = _S187;
    var _S188 : vec3<f32> = path_changing_0(number_of_path_0, &(at_0));
    path_5.throughput_0 = _S188;
    var _S189 : vec3<f32> = path_changing_0(number_of_path_0, &(at_0));
    path_5.direction_1 = _S189;
    var _S190 : Place_0 = path_place_0(number_of_path_0, &(at_0));
    path_5.place_1 = _S190;
    path_5.key_0 = vec2<u32>(path_word_0(number_of_path_0, at_0), path_word_0(number_of_path_0, at_0 + u32(1)));
    return path_5;
}

fn kept_at_0( depth_1 : u32) -> u32
{
    return u32(33) + u32(29) * depth_1;
}

fn change_word_0( at_1 : u32) -> u32
{
    return input_0[launch_0.room_0 + at_1];
}

fn edge_word_0( at_2 : u32) -> u32
{
    return change_word_0(change_word_0(u32(3)) + at_2);
}

fn word_0( at_3 : u32) -> u32
{
    return scene_0[at_3];
}

fn triangle_record_0( triangle_2 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_2;
}

fn shape_of_0( triangle_3 : u32) -> u32
{
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_3));
}

fn primitive_vector_0( at_4 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_0[at_4], primitives_0[at_4 + u32(1)], primitives_0[at_4 + u32(2)]);
}

fn position_of_0( place_2 : Place_0) -> vec3<f64>
{
    var at_5 : u32 = u32(9) * place_2.triangle_0;
    var a_2 : vec3<f64> = primitive_vector_0(at_5);
    return a_2 + (primitive_vector_0(at_5 + u32(3)) - a_2) * vec3<f64>((f64(place_2.v_0) + f64(place_2.v_rest_0))) + (primitive_vector_0(at_5 + u32(6)) - a_2) * vec3<f64>((f64(place_2.w_0) + f64(place_2.w_rest_0)));
}

fn cross_of_0( triangle_4 : u32) -> vec3<f32>
{
    var at_6 : u32 = u32(9) * triangle_4;
    var a_3 : vec3<f64> = primitive_vector_0(at_6);
    return cross(vec3<f32>(primitive_vector_0(at_6 + u32(3)) - a_3), vec3<f32>(primitive_vector_0(at_6 + u32(6)) - a_3));
}

fn unit_0( v_2 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_2 / vec3<f32>(max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z))));
}

fn number_0( at_7 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_7])));
}

fn vector_at_0( at_8 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_8), number_0(at_8 + u32(1)), number_0(at_8 + u32(2)));
}

struct Surface_0
{
     place_3 : Place_0,
     shape_0 : u32,
     exact_0 : vec3<f64>,
     position_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     outward_0 : vec3<f32>,
     is_front_0 : bool,
};

fn surface_at_0( place_4 : Place_0,  direction_2 : vec3<f32>) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.place_3 = place_4;
    surface_0.shape_0 = shape_of_0(place_4.triangle_0);
    var _S191 : vec3<f64> = position_of_0(place_4);
    surface_0.exact_0 = _S191;
    surface_0.position_0 = vec3<f32>(_S191);
    var _S192 : vec3<f32> = unit_0(cross_of_0(place_4.triangle_0));
    surface_0.face_normal_0 = _S192;
    surface_0.outward_0 = _S192;
    var seen_0 : f32;
    if((dot(_S192, direction_2)) > 0.0f)
    {
        seen_0 = -1.0f;
    }
    else
    {
        seen_0 = 1.0f;
    }
    var normals_0 : u32 = word_0(surface_0.shape_0);
    if(normals_0 != u32(4294967295))
    {
        var record_0 : u32 = triangle_record_0(place_4.triangle_0) + u32(2);
        var a_4 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0));
        var b_1 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(1)));
        var c_0 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(2)));
        if((dot(a_4 + b_1 + c_0, surface_0.face_normal_0)) < 0.0f)
        {
            seen_0 = - seen_0;
        }
        surface_0.outward_0 = normalize(a_4 + (b_1 - a_4) * vec3<f32>(place_4.v_0) + (c_0 - a_4) * vec3<f32>(place_4.w_0));
    }
    surface_0.is_front_0 = seen_0 > 0.0f;
    return surface_0;
}

fn material_of_0( surface_1 : Surface_0) -> u32
{
    var _S193 : u32;
    if(surface_1.is_front_0)
    {
        _S193 = u32(2);
    }
    else
    {
        _S193 = u32(3);
    }
    return word_0(surface_1.shape_0 + _S193);
}

struct Numbers_0
{
     diffuse_reflectance_0 : vec3<f32>,
     specular_reflectance_0 : vec3<f32>,
     eta_0 : vec3<f32>,
     k_0 : vec3<f32>,
     alpha_0 : vec2<f32>,
};

fn no_numbers_0() -> Numbers_0
{
    var numbers_0 : Numbers_0;
    var _S194 : vec3<f32> = vec3<f32>(0.0f);
    numbers_0.k_0 = _S194;
    numbers_0.eta_0 = _S194;
    numbers_0.specular_reflectance_0 = _S194;
    numbers_0.diffuse_reflectance_0 = _S194;
    numbers_0.alpha_0 = vec2<f32>(0.0f);
    return numbers_0;
}

struct Lookup_0
{
     count_0 : u32,
     texels_0 : vec4<u32>,
     weights_0 : vec4<f32>,
     by_first_0 : vec4<f32>,
     by_second_0 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_0 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    var _S195 : vec4<f32> = vec4<f32>(0.0f);
    lookup_0.by_second_0 = _S195;
    lookup_0.by_first_0 = _S195;
    return lookup_0;
}

struct Corners2_0
{
     a_5 : vec2<f64>,
     b_2 : vec2<f64>,
     c_1 : vec2<f64>,
};

fn Corners2_x24init_0( a_6 : vec2<f64>,  b_3 : vec2<f64>,  c_2 : vec2<f64>) -> Corners2_0
{
    var _S196 : Corners2_0;
    _S196.a_5 = a_6;
    _S196.b_2 = b_3;
    _S196.c_1 = c_2;
    return _S196;
}

fn precise_0( at_9 : u32) -> f64
{
    return f64(number_0(at_9)) + f64(number_0(at_9 + u32(1)));
}

fn uvs_of_0( triangle_5 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f64>(0.0lf, 0.0lf), vec2<f64>(1.0lf, 0.0lf), vec2<f64>(0.0lf, 1.0lf));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_5) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_10 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_5) + u32(1));
    uvs_0.a_5 = vec2<f64>(precise_0(at_10), precise_0(at_10 + u32(2)));
    uvs_0.b_2 = vec2<f64>(precise_0(at_10 + u32(4)), precise_0(at_10 + u32(6)));
    uvs_0.c_1 = vec2<f64>(precise_0(at_10 + u32(8)), precise_0(at_10 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_11 : u32) -> vec3<f64>
{
    return vec3<f64>(precise_0(at_11), precise_0(at_11 + u32(2)), precise_0(at_11 + u32(4)));
}

fn floor_of_0( x_4 : f64) -> i32
{
    return i32(clamp(f32(floor(x_4)), -1.0e+09f, 1.0e+09f));
}

fn wrapped_0( i_0 : i32,  n_1 : i32,  wrap_0 : u32) -> u32
{
    if(wrap_0 == u32(2))
    {
        return u32(clamp(i_0, i32(0), n_1 - i32(1)));
    }
    var period_0 : i32;
    if(wrap_0 == u32(1))
    {
        period_0 = i32(2) * n_1;
    }
    else
    {
        period_0 = n_1;
    }
    var inside_0 : i32 = i_0 % period_0;
    var inside_1 : i32;
    if(inside_0 < i32(0))
    {
        inside_1 = inside_0 + period_0;
    }
    else
    {
        inside_1 = inside_0;
    }
    if(inside_1 < n_1)
    {
        period_0 = inside_1;
    }
    else
    {
        period_0 = i32(2) * n_1 - i32(1) - inside_1;
    }
    return u32(period_0);
}

struct Point_0
{
     value_1 : vec2<f64>,
     by_first_1 : vec2<f32>,
     by_second_1 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_5 : Point_0) -> Lookup_0
{
    var _S197 : vec2<f32> = vec2<f32>(place_5.value_1 - floor(place_5.value_1));
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - _S197;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S198 : f32 = back_0.x;
    var _S199 : f32 = back_0.y;
    var _S200 : f32 = _S197.x;
    var _S201 : f32 = _S197.y;
    lookup_1.weights_0 = vec4<f32>(_S198 * _S199, _S200 * _S199, _S198 * _S201, _S200 * _S201);
    var by_x_0 : vec4<f32> = vec4<f32>(- _S199, _S199, - _S201, _S201);
    var by_y_0 : vec4<f32> = vec4<f32>(- _S198, - _S200, _S198, _S200);
    lookup_1.by_first_0 = by_x_0 * vec4<f32>(place_5.by_first_1.x) + by_y_0 * vec4<f32>(place_5.by_first_1.y);
    lookup_1.by_second_0 = by_x_0 * vec4<f32>(place_5.by_second_1.x) + by_y_0 * vec4<f32>(place_5.by_second_1.y);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var size_0 : vec2<f32> = vec2<f32>(f32(width_0), f32(height_0));
    var place_6 : vec2<f64> = uv_0.value_1 * vec2<f64>(size_0);
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_6.y), height_0, wrap_1);
        var _S202 : u32 = row_0 * u32(width_0);
        var _S203 : u32 = wrapped_0(floor_of_0(place_6.x), width_0, wrap_1);
        return one_texel_0(_S202 + _S203);
    }
    var centred_0 : Point_0;
    var _S204 : vec2<f64> = place_6 - vec2<f64>(0.5lf);
    centred_0.value_1 = _S204;
    centred_0.by_first_1 = uv_0.by_first_1 * size_0;
    centred_0.by_second_1 = uv_0.by_second_1 * size_0;
    var x_5 : i32 = floor_of_0(_S204.x);
    var y_1 : i32 = floor_of_0(_S204.y);
    var _S205 : u32 = wrapped_0(y_1, height_0, wrap_1);
    var _S206 : u32 = u32(width_0);
    var first_1 : u32 = _S205 * _S206;
    var _S207 : u32 = wrapped_0(y_1 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S207 * _S206;
    var left_0 : u32 = wrapped_0(x_5, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_5 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_7 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_7.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_7.v_0 - place_7.w_0, place_7.v_0, place_7.w_0, 0.0f);
        lookup_2.by_first_0 = vec4<f32>(-1.0f, 1.0f, 0.0f, 0.0f);
        lookup_2.by_second_0 = vec4<f32>(-1.0f, 0.0f, 1.0f, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_7.triangle_0);
    var by_v_0 : vec2<f64> = uvs_1.b_2 - uvs_1.a_5;
    var by_w_0 : vec2<f64> = uvs_1.c_1 - uvs_1.a_5;
    var _S208 : u32 = texture_1 + u32(6);
    var to_u_0 : vec3<f64> = row_at_0(_S208);
    var to_v_0 : vec3<f64> = row_at_0(_S208 + u32(6));
    var uv_1 : Point_0;
    var _S209 : vec3<f64> = vec3<f64>(uvs_1.a_5 + by_v_0 * vec2<f64>((f64(place_7.v_0) + f64(place_7.v_rest_0))) + by_w_0 * vec2<f64>((f64(place_7.w_0) + f64(place_7.w_rest_0))), 1.0lf);
    uv_1.value_1 = vec2<f64>(dot(_S209, to_u_0), dot(_S209, to_v_0));
    var _S210 : vec2<f64> = to_u_0.xy;
    var _S211 : vec2<f64> = to_v_0.xy;
    uv_1.by_first_1 = vec2<f32>(vec2<f64>(dot(by_v_0, _S210), dot(by_v_0, _S211)));
    uv_1.by_second_1 = vec2<f32>(vec2<f64>(dot(by_w_0, _S210), dot(by_w_0, _S211)));
    if(kind_0 == u32(1))
    {
        var _S212 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S212;
    }
    var half_of_period_0 : vec2<f64> = uv_1.value_1 - floor(uv_1.value_1);
    var _S213 : i32;
    if(((half_of_period_0.x) > 0.5lf) != ((half_of_period_0.y) > 0.5lf))
    {
        _S213 = i32(1);
    }
    else
    {
        _S213 = i32(0);
    }
    return one_texel_0(u32(_S213));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S214 : u32 = word_0(texture_2 + u32(1));
    var _S215 : u32 = texture_2 + u32(19);
    var _S216 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_2 : vec3<f32> = _S216;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_12 : u32 = _S215 + _S214 * lookup_3.texels_0[k_1];
        var _S217 : vec3<f32>;
        if(_S214 == u32(1))
        {
            _S217 = vec3<f32>(number_0(at_12));
        }
        else
        {
            _S217 = vector_at_0(at_12);
        }
        var value_3 : vec3<f32> = value_2 + _S217 * vec3<f32>(weights_1[k_1]);
        k_1 = k_1 + u32(1);
        value_2 = value_3;
    }
    return value_2;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_0);
}

fn shown_0( texture_4 : u32,  place_8 : Place_0) -> vec3<f32>
{
    var _S218 : Lookup_0 = lookup_at_0(texture_4, place_8);
    return looked_up_0(texture_4, _S218, vec2<f32>(0.0f));
}

fn value_of_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0;
}

fn luminance_0( colour_0 : vec3<f32>) -> f32
{
    return dot(colour_0, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f));
}

fn set_slot_0( numbers_1 : ptr<function, Numbers_0>,  slot_0 : u32,  value_4 : vec3<f32>)
{
    switch(slot_0)
    {
    case u32(0):
        {
            (*numbers_1).diffuse_reflectance_0 = value_4;
            break;
        }
    case u32(1):
        {
            (*numbers_1).specular_reflectance_0 = value_4;
            break;
        }
    case u32(2):
        {
            (*numbers_1).eta_0 = value_4;
            break;
        }
    case u32(3):
        {
            (*numbers_1).k_0 = value_4;
            break;
        }
    case u32(4):
        {
            (*numbers_1).alpha_0[i32(0)] = luminance_0(value_4);
            break;
        }
    default :
        {
            (*numbers_1).alpha_0[i32(1)] = luminance_0(value_4);
            break;
        }
    }
    return;
}

struct Lobe_0
{
     record_2 : u32,
     kind_1 : u32,
     distribution_0 : u32,
     numbers_2 : Numbers_0,
};

fn lobe_at_0( record_3 : u32,  place_9 : Place_0) -> Lobe_0
{
    var lobe_0 : Lobe_0;
    lobe_0.record_2 = record_3;
    var is_black_0 : bool = record_3 == u32(4294967295);
    var _S219 : u32;
    if(is_black_0)
    {
        _S219 = u32(0);
    }
    else
    {
        _S219 = word_0(record_3);
    }
    lobe_0.kind_1 = _S219;
    if(is_black_0)
    {
        _S219 = u32(1);
    }
    else
    {
        _S219 = word_0(record_3 + u32(1));
    }
    lobe_0.distribution_0 = _S219;
    lobe_0.numbers_2 = no_numbers_0();
    if(is_black_0)
    {
        _S219 = u32(0);
    }
    else
    {
        _S219 = word_0(record_3 + u32(4));
    }
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < _S219)
        {
        }
        else
        {
            break;
        }
        var texture_5 : u32 = word_0(record_3 + u32(5) + slot_1);
        if(texture_5 == u32(4294967295))
        {
            slot_1 = slot_1 + u32(1);
            continue;
        }
        var colour_1 : vec3<f32> = shown_0(texture_5, place_9);
        var _S220 : vec3<f32> = value_of_0(colour_1);
        var _S221 : Numbers_0 = lobe_0.numbers_2;
        set_slot_0(&(_S221), slot_1, _S220);
        lobe_0.numbers_2 = _S221;
        slot_1 = slot_1 + u32(1);
    }
    return lobe_0;
}

fn tangent_at_0( surface_2 : Surface_0) -> vec3<f32>
{
    var tangents_0 : u32 = word_0(surface_2.shape_0 + u32(5));
    if(tangents_0 == u32(4294967295))
    {
        return vec3<f32>(0.0f);
    }
    var tangent_0 : vec3<f32> = vector_at_0(tangents_0 + u32(3) * word_0(triangle_record_0(surface_2.place_3.triangle_0) + u32(1)));
    var across_0 : vec3<f32> = cross(tangent_0, surface_2.outward_0);
    var _S222 : vec3<f32>;
    if((dot(across_0, across_0)) > 0.0f)
    {
        _S222 = tangent_0;
    }
    else
    {
        _S222 = vec3<f32>(0.0f);
    }
    return _S222;
}

fn axes_along_0( n_2 : vec3<f32>,  tangent_1 : vec3<f32>,  is_front_1 : bool) -> Axes_0
{
    var axes_0 : Axes_0;
    var _S223 : vec3<f32>;
    if(is_front_1)
    {
        _S223 = n_2;
    }
    else
    {
        _S223 = (vec3<f32>(0) - n_2);
    }
    axes_0.n_0 = _S223;
    var _S224 : vec3<f32> = normalize(tangent_1 - n_2 * vec3<f32>(dot(n_2, tangent_1)));
    axes_0.s_0 = _S224;
    axes_0.t_0 = cross(n_2, _S224);
    return axes_0;
}

fn axes_around_0( n_3 : vec3<f32>,  is_front_2 : bool) -> Axes_0
{
    var axes_1 : Axes_0;
    var _S225 : vec3<f32>;
    if(is_front_2)
    {
        _S225 = n_3;
    }
    else
    {
        _S225 = (vec3<f32>(0) - n_3);
    }
    axes_1.n_0 = _S225;
    var _S226 : f32 = n_3.z;
    var sign_1 : f32;
    if(_S226 < -0.00000999999974738f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var a_7 : f32 = -1.0f / (sign_1 + _S226);
    var _S227 : f32 = n_3.x;
    var _S228 : f32 = n_3.y;
    var b_4 : f32 = _S227 * _S228 * a_7;
    axes_1.s_0 = vec3<f32>(1.0f + sign_1 * _S227 * _S227 * a_7, sign_1 * b_4, - sign_1 * _S227);
    axes_1.t_0 = vec3<f32>(b_4, sign_1 + _S228 * _S228 * a_7, - _S228);
    return axes_1;
}

fn to_local_0( axes_2 : Axes_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(axes_2.s_0, v_3), dot(axes_2.t_0, v_3), dot(axes_2.n_0, v_3));
}

fn towards_viewer_0( axes_3 : Axes_0,  direction_3 : vec3<f32>) -> vec3<f32>
{
    var wi_0 : vec3<f32> = (vec3<f32>(0) - to_local_0(axes_3, direction_3));
    return vec3<f32>(wi_0.x, wi_0.y, max(abs(wi_0.z), 9.999999960041972e-13f));
}

struct Vertex_0
{
     surface_3 : Surface_0,
     axes_4 : Axes_0,
     lobe_1 : Lobe_0,
     wi_1 : vec3<f32>,
};

fn vertex_at_0( surface_4 : Surface_0,  material_0 : u32,  direction_4 : vec3<f32>) -> Vertex_0
{
    var vertex_0 : Vertex_0;
    vertex_0.surface_3 = surface_4;
    var _S229 : Lobe_0 = lobe_at_0(material_0, surface_4.place_3);
    vertex_0.lobe_1 = _S229;
    var tangent_2 : vec3<f32> = tangent_at_0(surface_4);
    if((any((tangent_2 != vec3<f32>(0.0f)))))
    {
        vertex_0.axes_4 = axes_along_0(surface_4.outward_0, tangent_2, surface_4.is_front_0);
    }
    else
    {
        vertex_0.axes_4 = axes_around_0(surface_4.outward_0, surface_4.is_front_0);
    }
    vertex_0.wi_1 = towards_viewer_0(vertex_0.axes_4, direction_4);
    return vertex_0;
}

fn exact_unit_0( v_4 : vec3<f64>) -> vec3<f64>
{
    return v_4 / vec3<f64>(sqrt(dot(v_4, v_4)));
}

struct Mirror_0
{
     corner_0 : vec3<f64>,
     ab_0 : vec3<f64>,
     ac_0 : vec3<f64>,
     normal_0 : vec3<f64>,
};

fn mirror_at_0( triangle_6 : u32) -> Mirror_0
{
    var at_13 : u32 = u32(9) * triangle_6;
    var mirror_0 : Mirror_0;
    var _S230 : vec3<f64> = primitive_vector_0(at_13);
    mirror_0.corner_0 = _S230;
    var _S231 : vec3<f64> = primitive_vector_0(at_13 + u32(3)) - _S230;
    mirror_0.ab_0 = _S231;
    var _S232 : vec3<f64> = primitive_vector_0(at_13 + u32(6)) - _S230;
    mirror_0.ac_0 = _S232;
    mirror_0.normal_0 = exact_unit_0(cross(_S231, _S232));
    return mirror_0;
}

struct Around_0
{
     position_1 : vec3<f64>,
     face_0 : vec3<f64>,
     tree_0 : u32,
     mirrors_0 : u32,
     occluder_0 : u32,
};

fn around_vertex_0( vertex_1 : Vertex_0,  depth_2 : u32) -> Around_0
{
    var face_1 : Mirror_0 = mirror_at_0(vertex_1.surface_3.place_3.triangle_0);
    var around_0 : Around_0;
    around_0.position_1 = vertex_1.surface_3.exact_0;
    around_0.face_0 = face_1.normal_0;
    around_0.tree_0 = edge_word_0(u32(1));
    around_0.mirrors_0 = min(word_0(u32(0)) - min(word_0(u32(0)), depth_2 + u32(2)), edge_word_0(u32(8)));
    around_0.occluder_0 = u32(4294967295);
    return around_0;
}

fn to_world_0( axes_5 : Axes_0,  v_5 : vec3<f32>) -> vec3<f32>
{
    return axes_5.s_0 * vec3<f32>(v_5.x) + axes_5.t_0 * vec3<f32>(v_5.y) + axes_5.n_0 * vec3<f32>(v_5.z);
}

fn first_number_0( depth_3 : u32) -> u32
{
    return edge_word_0(u32(6)) + depth_3 * edge_word_0(u32(7));
}

fn real_place_0( at_14 : u32) -> u32
{
    return word_0(u32(15)) + u32(4) + at_14;
}

fn edge_real_0( at_15 : u32) -> f64
{
    return primitives_0[real_place_0(at_15)];
}

fn product_0( a_8 : u32,  b_5 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_8 & (u32(65535)));
    var a1_0 : u32 = (a_8 >> (u32(16)));
    var b0_0 : u32 = (b_5 & (u32(65535)));
    var b1_0 : u32 = (b_5 >> (u32(16)));
    var low_0 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_0 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_0 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_9 : vec2<u32>,  b_6 : vec2<u32>) -> vec2<u32>
{
    var _S233 : u32 = a_9.x;
    var _S234 : u32 = b_6.x;
    var low_1 : vec2<u32> = product_0(_S233, _S234);
    return vec2<u32>(low_1.x, low_1.y + _S233 * b_6.y + a_9.y * _S234);
}

fn plus_0( a_10 : vec2<u32>,  b_7 : vec2<u32>) -> vec2<u32>
{
    var _S235 : u32 = a_10.x;
    var low_2 : u32 = _S235 + b_7.x;
    var _S236 : u32 = a_10.y + b_7.y;
    var _S237 : i32;
    if(low_2 < _S235)
    {
        _S237 = i32(1);
    }
    else
    {
        _S237 = i32(0);
    }
    return vec2<u32>(low_2, _S236 + u32(_S237));
}

fn shifted_xor_0( x_6 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S238 : u32 = x_6.y;
    return (x_6 ^ (vec2<u32>(((((x_6.x) >> (by_0))) | (((_S238 << ((u32(32) - by_0)))))), (_S238 >> (by_0)))));
}

fn mix_0( x_7 : vec2<u32>) -> vec2<u32>
{
    return shifted_xor_0(times_0(shifted_xor_0(times_0(shifted_xor_0(x_7, u32(30)), vec2<u32>(u32(484763065), u32(3210233709))), u32(27)), vec2<u32>(u32(321982955), u32(2496678331))), u32(31));
}

fn random_bits_0( key_1 : vec2<u32>,  dimension_0 : u32) -> vec2<u32>
{
    return mix_0(plus_0(key_1, times_0(vec2<u32>(dimension_0 + u32(1), u32(0)), vec2<u32>(u32(2135587861), u32(2654435769)))));
}

fn random_0( key_2 : vec2<u32>,  dimension_1 : u32) -> f32
{
    return f32(((random_bits_0(key_2, dimension_1).y) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn walked_0( direction_5 : vec3<f64>,  tangent_3 : vec3<f64>,  half_sine_0 : f64) -> vec3<f64>
{
    var squared_0 : f64 = half_sine_0 * half_sine_0;
    return direction_5 * vec3<f64>((1.0lf - 2.0lf * squared_0)) + tangent_3 * vec3<f64>((2.0lf * half_sine_0 * sqrt(1.0lf - squared_0)));
}

fn length_of_0( v_6 : vec3<f64>) -> f64
{
    return sqrt(dot(v_6, v_6));
}

fn limit_at_0( which_5 : u32) -> f64
{
    return primitives_0[word_0(u32(15)) + which_5];
}

fn half_tangent_between_0( a_11 : vec3<f64>,  b_8 : vec3<f64>) -> f64
{
    var beside_0 : f64 = 1.0lf + dot(a_11, b_8);
    var _S239 : f64;
    if(beside_0 > 0.0lf)
    {
        _S239 = length_of_0(cross(a_11, b_8)) / beside_0;
    }
    else
    {
        _S239 = limit_at_0(u32(1));
    }
    return _S239;
}

fn component_0( v_7 : vec3<f64>,  axis_0 : u32) -> f64
{
    var _S240 : f64;
    if(axis_0 == u32(0))
    {
        _S240 = v_7.x;
    }
    else
    {
        if(axis_0 == u32(1))
        {
            _S240 = v_7.y;
        }
        else
        {
            _S240 = v_7.z;
        }
    }
    return _S240;
}

struct Ray_0
{
     origin_0 : vec3<f64>,
     shear_x_0 : f64,
     shear_y_0 : f64,
     inverse_z_0 : f64,
     t_min_0 : f64,
     t_max_0 : f64,
     local_per_t_0 : f64,
     enter_0 : f64,
     edge_on_0 : f64,
     largest_0 : f64,
};

fn ray_along_0( origin_1 : vec3<f64>,  direction_6 : vec3<f64>,  t_min_1 : f64,  t_max_1 : f64,  axes_6 : ptr<function, u32>) -> Ray_0
{
    var size_1 : vec3<f32> = abs(vec3<f32>(direction_6));
    var _S241 : f32 = size_1.x;
    var _S242 : f32 = size_1.y;
    var _S243 : bool;
    if(_S241 >= _S242)
    {
        _S243 = _S241 >= (size_1.z);
    }
    else
    {
        _S243 = false;
    }
    var _S244 : i32;
    if(_S243)
    {
        _S244 = i32(0);
    }
    else
    {
        if(_S242 >= (size_1.z))
        {
            _S244 = i32(1);
        }
        else
        {
            _S244 = i32(2);
        }
    }
    var z_0 : u32 = u32(_S244);
    var x_8 : u32 = (z_0 + u32(1)) % u32(3);
    var y_2 : u32 = (z_0 + u32(2)) % u32(3);
    (*axes_6) = (((x_8 | (((y_2 << (u32(2))))))) | (((z_0 << (u32(4))))));
    var ray_0 : Ray_0;
    ray_0.origin_0 = origin_1;
    var along_0 : f64 = component_0(direction_6, z_0);
    ray_0.inverse_z_0 = 1.0lf / along_0;
    ray_0.shear_x_0 = component_0(direction_6, x_8) / along_0;
    ray_0.shear_y_0 = component_0(direction_6, y_2) / along_0;
    ray_0.t_min_0 = t_min_1;
    ray_0.t_max_0 = t_max_1;
    ray_0.local_per_t_0 = abs(along_0);
    ray_0.enter_0 = 0.0lf;
    ray_0.edge_on_0 = limit_at_0(u32(0));
    ray_0.largest_0 = limit_at_0(u32(1));
    return ray_0;
}

fn ray_along_1( origin_2 : vec3<f64>,  direction_7 : vec3<f64>,  t_min_2 : f64,  t_max_2 : f64,  axes_7 : ptr<function, u32>) -> Ray_0
{
    var size_2 : vec3<f32> = abs(vec3<f32>(direction_7));
    var _S245 : f32 = size_2.x;
    var _S246 : f32 = size_2.y;
    var _S247 : bool;
    if(_S245 >= _S246)
    {
        _S247 = _S245 >= (size_2.z);
    }
    else
    {
        _S247 = false;
    }
    var _S248 : i32;
    if(_S247)
    {
        _S248 = i32(0);
    }
    else
    {
        if(_S246 >= (size_2.z))
        {
            _S248 = i32(1);
        }
        else
        {
            _S248 = i32(2);
        }
    }
    var z_1 : u32 = u32(_S248);
    var x_9 : u32 = (z_1 + u32(1)) % u32(3);
    var y_3 : u32 = (z_1 + u32(2)) % u32(3);
    (*axes_7) = (((x_9 | (((y_3 << (u32(2))))))) | (((z_1 << (u32(4))))));
    var ray_1 : Ray_0;
    ray_1.origin_0 = origin_2;
    var along_1 : f64 = component_0(direction_7, z_1);
    ray_1.inverse_z_0 = 1.0lf / along_1;
    ray_1.shear_x_0 = component_0(direction_7, x_9) / along_1;
    ray_1.shear_y_0 = component_0(direction_7, y_3) / along_1;
    ray_1.t_min_0 = t_min_2;
    ray_1.t_max_0 = t_max_2;
    ray_1.local_per_t_0 = abs(along_1);
    ray_1.enter_0 = 0.0lf;
    ray_1.edge_on_0 = limit_at_0(u32(0));
    ray_1.largest_0 = limit_at_0(u32(1));
    return ray_1;
}

fn ray_child_0( node_0 : u32,  slot_2 : u32) -> u32
{
    return nodes_0[u32(14) * node_0 + u32(12) + slot_2 / u32(4)][slot_2 % u32(4)];
}

struct RayView_0
{
     inverse_0 : vec3<f32>,
     offset_near_0 : vec3<f32>,
     offset_far_0 : vec3<f32>,
     limit_0 : f32,
     margin_0 : f32,
     axes_8 : u32,
};

fn ray_bound_0( view_0 : RayView_0,  limit_1 : f32,  node_1 : u32,  slot_3 : u32) -> f32
{
    var _S249 : u32 = u32(14) * node_1 + slot_3 / u32(4);
    var near_0 : f32 = 0.0f;
    var far_0 : f32 = limit_1;
    var axis_1 : u32 = u32(0);
    for(;;)
    {
        if(axis_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S250 : u32 = axis_1;
        var _S251 : u32 = _S249 + u32(2) * axis_1;
        var _S252 : u32 = slot_3 % u32(4);
        var low_3 : f32 = (bitcast<f32>((nodes_0[_S251][_S252])));
        var high_0 : f32 = (bitcast<f32>((nodes_0[_S251 + u32(6)][_S252])));
        var _S253 : bool = (view_0.inverse_0[axis_1]) < 0.0f;
        var _S254 : f32;
        if(_S253)
        {
            _S254 = high_0;
        }
        else
        {
            _S254 = low_3;
        }
        var _S255 : f32 = max(near_0, _S254 * view_0.inverse_0[_S250] - view_0.offset_near_0[axis_1]);
        var _S256 : f32;
        if(_S253)
        {
            _S256 = low_3;
        }
        else
        {
            _S256 = high_0;
        }
        var _S257 : f32 = min(far_0, _S256 * view_0.inverse_0[_S250] - view_0.offset_far_0[axis_1]);
        var _S258 : u32 = axis_1 + u32(1);
        near_0 = _S255;
        far_0 = _S257;
        axis_1 = _S258;
    }
    if(near_0 <= far_0)
    {
    }
    else
    {
        near_0 = 3.00000000549775576e+38f;
    }
    return near_0;
}

fn nearest_first_0( bounds_0 : array<f32, i32(8)>,  limit_2 : f32) -> u32
{
    var k_2 : u32 = u32(0);
    var order_0 : u32 = u32(0);
    for(;;)
    {
        if(k_2 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S259 : u32 = k_2;
        if((bounds_0[k_2]) > limit_2)
        {
            k_2 = k_2 + u32(1);
            continue;
        }
        var j_0 : u32 = u32(0);
        var rank_0 : u32 = u32(0);
        for(;;)
        {
            if(j_0 < u32(8))
            {
            }
            else
            {
                break;
            }
            var _S260 : u32 = j_0;
            var _S261 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S259]))
            {
                _S261 = true;
            }
            else
            {
                if((bounds_0[_S260]) == (bounds_0[_S259]))
                {
                    _S261 = j_0 < k_2;
                }
                else
                {
                    _S261 = false;
                }
            }
            if(_S261)
            {
                rank_0 = rank_0 + u32(1);
            }
            j_0 = j_0 + u32(1);
        }
        order_0 = (order_0 | ((((k_2 + u32(1)) << ((u32(4) * rank_0))))));
        k_2 = k_2 + u32(1);
    }
    return order_0;
}

fn crossed_0( view_1 : RayView_0,  limit_3 : f32,  node_2 : u32) -> u32
{
    var bounds_1 : array<f32, i32(8)>;
    var slot_4 : u32 = u32(0);
    for(;;)
    {
        if(slot_4 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S262 : f32;
        if((ray_child_0(node_2, slot_4)) == u32(4294967295))
        {
            _S262 = 3.00000000549775576e+38f;
        }
        else
        {
            _S262 = ray_bound_0(view_1, limit_3, node_2, slot_4);
        }
        bounds_1[slot_4] = _S262;
        slot_4 = slot_4 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_1 : f64,  largest_1 : f64) -> f64
{
    return min(product_1, largest_1);
}

fn corner_1( ray_2 : Ray_0,  axes_9 : u32,  at_16 : u32) -> vec3<f64>
{
    var relative_0 : vec3<f64> = primitive_vector_0(at_16) - ray_2.origin_0;
    var z_2 : f64 = component_0(relative_0, (axes_9 >> (u32(4))));
    return vec3<f64>(component_0(relative_0, (axes_9 & (u32(3)))) - rounded_0(ray_2.shear_x_0 * z_2, ray_2.largest_0), component_0(relative_0, (((axes_9 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_2.shear_y_0 * z_2, ray_2.largest_0), z_2);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_1 : f64,
     v_8 : f64,
     w_2 : f64,
};

fn intersect_0( ray_3 : Ray_0,  axes_10 : u32,  at_17 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_1 = 0.0lf;
    crossing_0.v_8 = 0.0lf;
    crossing_0.w_2 = 0.0lf;
    var a_12 : vec3<f64> = corner_1(ray_3, axes_10, at_17);
    var b_9 : vec3<f64> = corner_1(ray_3, axes_10, at_17 + u32(3));
    var c_3 : vec3<f64> = corner_1(ray_3, axes_10, at_17 + u32(6));
    var _S263 : f64 = c_3.x;
    var _S264 : f64 = b_9.y;
    var cx_by_0 : f64 = rounded_0(_S263 * _S264, ray_3.largest_0);
    var _S265 : f64 = c_3.y;
    var _S266 : f64 = b_9.x;
    var cy_bx_0 : f64 = rounded_0(_S265 * _S266, ray_3.largest_0);
    var _S267 : f64 = a_12.x;
    var ax_cy_0 : f64 = rounded_0(_S267 * _S265, ray_3.largest_0);
    var _S268 : f64 = a_12.y;
    var ay_cx_0 : f64 = rounded_0(_S268 * _S263, ray_3.largest_0);
    var bx_ay_0 : f64 = rounded_0(_S266 * _S268, ray_3.largest_0);
    var by_ax_0 : f64 = rounded_0(_S264 * _S267, ray_3.largest_0);
    var u_0 : f64 = cx_by_0 - cy_bx_0;
    var v_9 : f64 = ax_cy_0 - ay_cx_0;
    var w_3 : f64 = bx_ay_0 - by_ax_0;
    var _S269 : f64 = min(min(u_0, v_9), w_3);
    var _S270 : f64 = max(max(u_0, v_9), w_3);
    var _S271 : bool;
    if(_S269 < 0.0lf)
    {
        _S271 = _S270 > 0.0lf;
    }
    else
    {
        _S271 = false;
    }
    if(_S271)
    {
        return crossing_0;
    }
    var determinant_0 : f64 = u_0 + v_9 + w_3;
    if(_S269 <= 0.0lf)
    {
        _S271 = _S270 >= 0.0lf;
    }
    else
    {
        _S271 = false;
    }
    if(_S271)
    {
        if((abs(determinant_0)) <= (ray_3.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0lf)
    {
        return crossing_0;
    }
    var t_2 : f64 = (rounded_0(u_0 * a_12.z, ray_3.largest_0) + rounded_0(v_9 * b_9.z, ray_3.largest_0) + rounded_0(w_3 * c_3.z, ray_3.largest_0)) / determinant_0 * ray_3.inverse_z_0;
    if((ray_3.t_min_0) <= t_2)
    {
        _S271 = t_2 <= (ray_3.t_max_0);
    }
    else
    {
        _S271 = false;
    }
    crossing_0.is_hit_0 = _S271;
    crossing_0.t_1 = t_2;
    crossing_0.v_8 = v_9 / determinant_0;
    crossing_0.w_2 = w_3 / determinant_0;
    return crossing_0;
}

fn face_2( triangle_7 : u32) -> u32
{
    return rough_0[triangle_7 / u32(4)][triangle_7 % u32(4)];
}

struct Found_0
{
     face_3 : u32,
     triangle_8 : u32,
     v_10 : f64,
     w_4 : f64,
};

fn first_found_0( view_2 : RayView_0,  ray_4 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S272 : bool;
    var found_0 : Found_0;
    found_0.face_3 = u32(4294967295);
    found_0.triangle_8 = u32(4294967295);
    found_0.v_10 = 0.0lf;
    found_0.w_4 = 0.0lf;
    if(!((view_2.limit_0) >= 0.0f))
    {
        return found_0;
    }
    var way_0 : array<vec2<u32>, i32(40)>;
    way_0[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_2.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_0[level_0] = vec2<u32>(entered_0, crossed_0(view_2, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_0 : vec2<u32> = way_0[level_0];
        var _S273 : u32 = way_0[level_0].y;
        if(_S273 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S274 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S274;
            continue;
        }
        var slot_5 : u32 = ((_S273 & (u32(15)))) - u32(1);
        way_0[level_0][i32(1)] = (_S273 >> (u32(4)));
        var _S275 : bool;
        if(!is_new_1)
        {
            _S275 = (ray_bound_0(view_2, limit_4, here_0.x, slot_5)) > limit_4;
        }
        else
        {
            _S275 = false;
        }
        if(_S275)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_0.x, slot_5);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S276 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S276;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S277 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S278 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_1 : u32 = _S278;
        for(;;)
        {
            if(i_1 < _S277)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_4), view_2.axes_8, u32(9) * i_1);
            if(!crossing_1.is_hit_0)
            {
                i_1 = i_1 + u32(1);
                continue;
            }
            if((found_0.face_3) == u32(4294967295))
            {
                _S272 = true;
            }
            else
            {
                _S272 = (crossing_1.t_1) < ((*ray_4).t_max_0);
            }
            var _S279 : bool;
            if(_S272)
            {
                _S279 = true;
            }
            else
            {
                _S279 = (face_2(i_1)) < (found_0.face_3);
            }
            var limit_6 : f32;
            if(_S279)
            {
                found_0.face_3 = face_2(i_1);
                found_0.triangle_8 = i_1;
                (*ray_4).t_max_0 = crossing_1.t_1;
                found_0.v_10 = crossing_1.v_8;
                found_0.w_4 = crossing_1.w_2;
                limit_6 = min(limit_5, f32(crossing_1.t_1 * (*ray_4).local_per_t_0 - (*ray_4).enter_0) + 2.0f * view_2.margin_0);
            }
            else
            {
                limit_6 = limit_5;
            }
            limit_5 = limit_6;
            i_1 = i_1 + u32(1);
        }
        if(any_0)
        {
            _S272 = (found_0.face_3) != u32(4294967295);
        }
        else
        {
            _S272 = false;
        }
        if(_S272)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_0;
}

fn cast_0( origin_3 : vec3<f64>,  direction_8 : vec3<f64>,  t_min_3 : f64,  t_max_3 : f64,  any_1 : bool,  t_3 : ptr<function, f32>) -> Found_0
{
    var view_3 : RayView_0;
    var _S280 : u32 = view_3.axes_8;
    var _S281 : Ray_0 = ray_along_1(origin_3, direction_8, t_min_3, t_max_3, &(_S280));
    view_3.axes_8 = _S280;
    var ray_5 : Ray_0 = _S281;
    var _S282 : vec3<f32> = vec3<f32>(direction_8 / vec3<f64>(ray_5.local_per_t_0));
    var axis_2 : u32 = u32(0);
    for(;;)
    {
        if(axis_2 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S283 : f32 = max(abs(_S282[axis_2]), 8.67361737988403547e-19f);
        var _S284 : f32;
        if((_S282[axis_2]) < 0.0f)
        {
            _S284 = -1.0f / _S283;
        }
        else
        {
            _S284 = 1.0f / _S283;
        }
        view_3.inverse_0[axis_2] = _S284;
        axis_2 = axis_2 + u32(1);
    }
    var offset_0 : vec3<f32> = vec3<f32>(origin_3) * view_3.inverse_0;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_3.inverse_0);
    view_3.offset_near_0 = offset_0 + wider_0;
    view_3.offset_far_0 = offset_0 - wider_0;
    view_3.limit_0 = min(f32(t_max_3 * ray_5.local_per_t_0), 8.0f) + 3.814697265625e-06f;
    view_3.margin_0 = 3.814697265625e-06f;
    var found_1 : Found_0 = first_found_0(view_3, &(ray_5), any_1);
    (*t_3) = f32(ray_5.t_max_0);
    return found_1;
}

fn is_mirror_0( triangle_9 : u32) -> bool
{
    return (word_0(shape_of_0(triangle_9) + u32(6))) != u32(0);
}

fn place_of_0( found_2 : Found_0) -> Place_0
{
    return exact_place_0(found_2.triangle_8, found_2.v_10, found_2.w_4);
}

fn mirrored_0( mirror_1 : Mirror_0,  direction_9 : vec3<f64>) -> vec3<f64>
{
    return direction_9 - mirror_1.normal_0 * vec3<f64>((2.0lf * dot(mirror_1.normal_0, direction_9)));
}

fn height_of_0( mirror_2 : Mirror_0,  place_10 : vec3<f64>) -> f64
{
    return dot(mirror_2.normal_0, place_10 - mirror_2.corner_0);
}

fn image_of_0( mirror_3 : Mirror_0,  place_11 : vec3<f64>) -> vec3<f64>
{
    return place_11 - mirror_3.normal_0 * vec3<f64>((2.0lf * height_of_0(mirror_3, place_11)));
}

struct Chain_0
{
     image_0 : vec3<f64>,
     start_0 : vec3<f64>,
     direction_10 : vec3<f64>,
     facing_0 : vec3<f64>,
     count_1 : u32,
     triangles_0 : array<u32, i32(6)>,
};

fn reflect_0( chain_0 : ptr<function, Chain_0>) -> bool
{
    var unused_0 : f32;
    var found_3 : Found_0 = cast_0((*chain_0).start_0, (*chain_0).direction_10, limit_at_0(u32(2)), limit_at_0(u32(1)), false, &(unused_0));
    var _S285 : bool;
    if((found_3.face_3) == u32(4294967295))
    {
        _S285 = true;
    }
    else
    {
        _S285 = !is_mirror_0(found_3.triangle_8);
    }
    if(_S285)
    {
        return false;
    }
    var mirror_4 : Mirror_0 = mirror_at_0(found_3.triangle_8);
    (*chain_0).start_0 = position_of_0(place_of_0(found_3));
    var _S286 : vec3<f64> = mirrored_0(mirror_4, (*chain_0).direction_10);
    (*chain_0).direction_10 = _S286;
    (*chain_0).image_0 = image_of_0(mirror_4, (*chain_0).image_0);
    var _S287 : vec3<f64>;
    if((dot(mirror_4.normal_0, _S286)) < 0.0lf)
    {
        _S287 = (vec3<f64>(0) - mirror_4.normal_0);
    }
    else
    {
        _S287 = mirror_4.normal_0;
    }
    (*chain_0).facing_0 = _S287;
    (*chain_0).triangles_0[(*chain_0).count_1] = found_3.triangle_8;
    (*chain_0).count_1 = (*chain_0).count_1 + u32(1);
    return true;
}

fn limit_by_0( half_tangent_0 : f64) -> vec2<f32>
{
    var _S288 : f32 = min(f32(half_tangent_0), 1.0e+09f);
    var squared_1 : f32 = _S288 * _S288;
    return vec2<f32>(1.0f - squared_1, 2.0f * _S288) / vec2<f32>((1.0f + squared_1));
}

fn edge_number_0( at_18 : u32) -> f32
{
    return (bitcast<f32>((edge_word_0(at_18))));
}

fn edge_vector_0( at_19 : u32) -> vec3<f32>
{
    return vec3<f32>(edge_number_0(at_19), edge_number_0(at_19 + u32(1)), edge_number_0(at_19 + u32(2)));
}

struct Ball_0
{
     from_axis_0 : f32,
     along_2 : f32,
     radius_0 : f32,
};

fn ball_of_0( node_3 : u32,  image_1 : vec3<f32>,  axis_3 : vec3<f32>) -> Ball_0
{
    var offset_1 : vec3<f32> = edge_vector_0(node_3 + u32(4)) - image_1;
    var ball_0 : Ball_0;
    ball_0.from_axis_0 = length(cross(axis_3, offset_1));
    ball_0.along_2 = dot(axis_3, offset_1);
    ball_0.radius_0 = 3.99999998990097083e-06f * (1.0f + length(offset_1)) + edge_number_0(node_3 + u32(7));
    return ball_0;
}

fn is_beyond_0( ball_1 : Ball_0,  limit_7 : vec2<f32>) -> bool
{
    return (ball_1.from_axis_0 * limit_7.x - ball_1.along_2 * limit_7.y) > (ball_1.radius_0);
}

fn comes_first_0( ball_2 : Ball_0,  other_0 : Ball_0) -> bool
{
    var _S289 : f32 = max(ball_2.from_axis_0 - ball_2.radius_0, 0.0f);
    var _S290 : f32 = max(other_0.from_axis_0 - other_0.radius_0, 0.0f);
    var _S291 : bool;
    if(_S289 == _S290)
    {
        _S291 = (ball_2.along_2) < (other_0.along_2);
    }
    else
    {
        _S291 = _S289 < _S290;
    }
    return _S291;
}

fn record_of_0( around_1 : Around_0,  edge_0 : u32) -> u32
{
    return edge_word_0(around_1.tree_0 + u32(1)) + u32(12) * edge_0;
}

fn edge_position_0( at_20 : u32) -> vec3<f64>
{
    return primitive_vector_0(real_place_0(at_20));
}

struct OnEdge_0
{
     t_4 : f64,
     sine_0 : f64,
     cosine_0 : f64,
     offset_2 : vec3<f64>,
};

fn on_edge_0( axis_4 : vec3<f64>,  t_5 : f64,  offset_3 : vec3<f64>) -> OnEdge_0
{
    var place_12 : OnEdge_0;
    place_12.t_4 = t_5;
    place_12.offset_2 = offset_3;
    place_12.sine_0 = length_of_0(cross(axis_4, offset_3));
    place_12.cosine_0 = dot(axis_4, offset_3);
    return place_12;
}

fn is_nearer_0( p_0 : OnEdge_0,  q_0 : OnEdge_0) -> bool
{
    return (p_0.sine_0 * q_0.cosine_0) < (q_0.sine_0 * p_0.cosine_0);
}

struct Candidate_0
{
     half_tangent_1 : f64,
     t_6 : f64,
     edge_1 : u32,
     number_1 : u32,
};

fn closest_on_edge_0( around_2 : Around_0,  chain_1 : Chain_0,  axis_5 : vec3<f64>,  edge_2 : u32,  candidate_0 : ptr<function, Candidate_0>) -> bool
{
    (*candidate_0).edge_1 = edge_2;
    (*candidate_0).number_1 = edge_word_0(record_of_0(around_2, edge_2) + u32(11));
    (*candidate_0).half_tangent_1 = 0.0lf;
    (*candidate_0).t_6 = 0.0lf;
    var numbers_3 : u32 = edge_word_0(around_2.tree_0 + u32(2)) + u32(14) * edge_2;
    var a_13 : vec3<f64> = edge_position_0(numbers_3) - chain_1.image_0;
    var b_10 : vec3<f64> = edge_position_0(numbers_3 + u32(3)) - chain_1.image_0;
    var along_3 : vec3<f64> = b_10 - a_13;
    var from_mirror_0 : vec3<f64> = chain_1.image_0 - chain_1.start_0;
    var _S292 : bool;
    if((dot(a_13 + from_mirror_0, chain_1.facing_0)) < 0.0lf)
    {
        _S292 = (dot(b_10 + from_mirror_0, chain_1.facing_0)) < 0.0lf;
    }
    else
    {
        _S292 = false;
    }
    if(_S292)
    {
        return false;
    }
    var across_1 : vec3<f64> = cross(a_13, along_3);
    if((dot(across_1, across_1)) == 0.0lf)
    {
        _S292 = (dot(a_13, b_10)) <= 0.0lf;
    }
    else
    {
        _S292 = false;
    }
    if(_S292)
    {
        return false;
    }
    var place_13 : OnEdge_0 = on_edge_0(axis_5, 0.0lf, a_13);
    var other_1 : OnEdge_0 = on_edge_0(axis_5, 1.0lf, b_10);
    var place_14 : OnEdge_0;
    if(is_nearer_0(other_1, place_13))
    {
        place_14 = other_1;
    }
    else
    {
        place_14 = place_13;
    }
    var w_5 : vec3<f64> = cross(axis_5, across_1);
    var falls_0 : f64 = dot(along_3, w_5);
    var t_7 : f64;
    if(falls_0 != 0.0lf)
    {
        t_7 = - dot(a_13, w_5) / falls_0;
    }
    else
    {
        t_7 = 0.0lf;
    }
    if(t_7 > 0.0lf)
    {
        _S292 = t_7 < 1.0lf;
    }
    else
    {
        _S292 = false;
    }
    if(_S292)
    {
        var other_2 : OnEdge_0 = on_edge_0(axis_5, t_7, a_13 + along_3 * vec3<f64>(t_7));
        if(is_nearer_0(other_2, place_14))
        {
            place_14 = other_2;
        }
    }
    var beside_1 : f64 = length_of_0(place_14.offset_2) + place_14.cosine_0;
    (*candidate_0).t_6 = place_14.t_4;
    (*candidate_0).half_tangent_1 = place_14.sine_0 / beside_1;
    return beside_1 > 0.0lf;
}

fn is_before_0( a_14 : Candidate_0,  b_11 : Candidate_0) -> bool
{
    var _S293 : bool;
    if((a_14.half_tangent_1) < (b_11.half_tangent_1))
    {
        _S293 = true;
    }
    else
    {
        if((a_14.half_tangent_1) == (b_11.half_tangent_1))
        {
            _S293 = (a_14.number_1) < (b_11.number_1);
        }
        else
        {
            _S293 = false;
        }
    }
    return _S293;
}

struct Candidates_0
{
     listed_0 : array<Candidate_0, i32(4)>,
     count_2 : u32,
};

fn has_room_0( candidates_0 : Candidates_0,  candidate_1 : Candidate_0) -> bool
{
    var _S294 : bool;
    if((candidates_0.count_2) < u32(4))
    {
        _S294 = true;
    }
    else
    {
        _S294 = is_before_0(candidate_1, candidates_0.listed_0[u32(3)]);
    }
    return _S294;
}

fn is_on_horizon_0( around_3 : Around_0,  edge_3 : u32) -> bool
{
    var numbers_4 : u32 = edge_word_0(around_3.tree_0 + u32(2)) + u32(14) * edge_3;
    return (max(abs(dot(edge_position_0(numbers_4) - around_3.position_1, around_3.face_0)), abs(dot(edge_position_0(numbers_4 + u32(3)) - around_3.position_1, around_3.face_0)))) <= (limit_at_0(u32(2)));
}

fn place_of_1( around_4 : Around_0,  candidate_2 : Candidate_0) -> vec3<f64>
{
    var numbers_5 : u32 = edge_word_0(around_4.tree_0 + u32(2)) + u32(14) * candidate_2.edge_1;
    var start_1 : vec3<f64> = edge_position_0(numbers_5);
    return start_1 + (edge_position_0(numbers_5 + u32(3)) - start_1) * vec3<f64>(candidate_2.t_6);
}

fn meets_0( triangle_10 : u32,  origin_4 : vec3<f64>,  direction_11 : vec3<f64>,  t_min_4 : f64,  t_max_4 : f64) -> bool
{
    var axes_11 : u32;
    var ray_6 : Ray_0 = ray_along_0(origin_4, direction_11, t_min_4, t_max_4, &(axes_11));
    return intersect_0(ray_6, axes_11, u32(9) * triangle_10).is_hit_0;
}

fn is_hidden_0( around_5 : Around_0,  candidate_3 : Candidate_0) -> bool
{
    var _S295 : bool;
    if((around_5.occluder_0) == u32(4294967295))
    {
        _S295 = true;
    }
    else
    {
        _S295 = is_on_horizon_0(around_5, candidate_3.edge_1);
    }
    if(_S295)
    {
        return false;
    }
    var way_1 : vec3<f64> = place_of_1(around_5, candidate_3) - around_5.position_1;
    var distance_1 : f64 = length_of_0(way_1);
    return meets_0(around_5.occluder_0, around_5.position_1, way_1 / vec3<f64>(distance_1), limit_at_0(u32(2)), distance_1 * limit_at_0(u32(3)));
}

fn list_0( candidates_1 : ptr<function, Candidates_0>,  candidate_4 : Candidate_0)
{
    var _S296 : u32 = min((*candidates_1).count_2, u32(3));
    (*candidates_1).count_2 = _S296 + u32(1);
    var place_15 : u32 = _S296;
    for(;;)
    {
        var _S297 : bool;
        if(place_15 > u32(0))
        {
            _S297 = is_before_0(candidate_4, (*candidates_1).listed_0[place_15 - u32(1)]);
        }
        else
        {
            _S297 = false;
        }
        if(_S297)
        {
        }
        else
        {
            break;
        }
        var _S298 : u32 = place_15 - u32(1);
        (*candidates_1).listed_0[place_15] = (*candidates_1).listed_0[_S298];
        place_15 = _S298;
    }
    (*candidates_1).listed_0[place_15] = candidate_4;
    return;
}

fn search_0( around_6 : Around_0,  chain_2 : Chain_0,  limit_8 : f64,  last_0 : Candidate_0) -> Candidates_0
{
    var found_4 : Candidates_0;
    found_4.count_2 = u32(0);
    var k_3 : u32 = u32(0);
    for(;;)
    {
        if(k_3 < u32(4))
        {
        }
        else
        {
            break;
        }
        found_4.listed_0[k_3] = last_0;
        k_3 = k_3 + u32(1);
    }
    var nodes_at_0 : u32 = edge_word_0(around_6.tree_0);
    var waiting_0 : array<u32, i32(92)>;
    waiting_0[i32(0)] = u32(4294967295);
    var _S299 : vec3<f32> = vec3<f32>(chain_2.image_0);
    var _S300 : vec3<f32> = vec3<f32>(chain_2.direction_10);
    var _S301 : vec2<f32> = limit_by_0(limit_8);
    var node_4 : u32 = nodes_at_0;
    var rough_limit_0 : vec2<f32> = _S301;
    var count_3 : u32 = u32(0);
    for(;;)
    {
        if(node_4 != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var next_0 : u32;
        var next_1 : u32;
        var count_4 : u32;
        var _S302 : bool;
        var skips_far_0 : bool;
        var _S303 : bool;
        if((edge_word_0(node_4)) != u32(4294967295))
        {
            var near_1 : u32 = node_4 + u32(45);
            var far_1 : u32 = nodes_at_0 + u32(45) * edge_word_0(node_4);
            var of_near_0 : Ball_0 = ball_of_0(near_1, _S299, _S300);
            var of_far_0 : Ball_0 = ball_of_0(far_1, _S299, _S300);
            var skips_near_0 : bool = is_beyond_0(of_near_0, rough_limit_0);
            var skips_far_1 : bool = is_beyond_0(of_far_0, rough_limit_0);
            if(!skips_far_1)
            {
                if(skips_near_0)
                {
                    _S302 = true;
                }
                else
                {
                    _S302 = comes_first_0(of_far_0, of_near_0);
                }
            }
            else
            {
                _S302 = false;
            }
            if(_S302)
            {
                next_0 = far_1;
                skips_far_0 = skips_near_0;
                next_1 = near_1;
            }
            else
            {
                if(!skips_near_0)
                {
                    next_0 = near_1;
                }
                else
                {
                    next_0 = u32(4294967295);
                }
                skips_far_0 = skips_far_1;
                next_1 = far_1;
            }
            if(next_0 != u32(4294967295))
            {
                _S303 = !skips_far_0;
            }
            else
            {
                _S303 = false;
            }
            if(_S303)
            {
                waiting_0[count_3] = next_1;
                count_4 = count_3 + u32(1);
            }
            else
            {
                count_4 = count_3;
            }
        }
        else
        {
            k_3 = edge_word_0(node_4 + u32(2));
            for(;;)
            {
                if(k_3 < (edge_word_0(node_4 + u32(3))))
                {
                }
                else
                {
                    break;
                }
                var candidate_5 : Candidate_0;
                var _S304 : bool = closest_on_edge_0(around_6, chain_2, chain_2.direction_10, k_3, &(candidate_5));
                if(!_S304)
                {
                    k_3 = k_3 + u32(1);
                    continue;
                }
                if(!((candidate_5.half_tangent_1) < limit_8))
                {
                    _S302 = true;
                }
                else
                {
                    _S302 = !is_before_0(last_0, candidate_5);
                }
                if(_S302)
                {
                    skips_far_0 = true;
                }
                else
                {
                    skips_far_0 = !has_room_0(found_4, candidate_5);
                }
                if(skips_far_0)
                {
                    k_3 = k_3 + u32(1);
                    continue;
                }
                if((chain_2.count_1) > u32(0))
                {
                    _S303 = true;
                }
                else
                {
                    _S303 = !is_hidden_0(around_6, candidate_5);
                }
                if(_S303)
                {
                    list_0(&(found_4), candidate_5);
                }
                k_3 = k_3 + u32(1);
            }
            var rough_limit_1 : vec2<f32>;
            if((found_4.count_2) == u32(4))
            {
                rough_limit_1 = limit_by_0(found_4.listed_0[u32(3)].half_tangent_1);
            }
            else
            {
                rough_limit_1 = rough_limit_0;
            }
            next_0 = u32(4294967295);
            rough_limit_0 = rough_limit_1;
            count_4 = count_3;
        }
        next_1 = next_0;
        count_3 = count_4;
        for(;;)
        {
            if(next_1 == u32(4294967295))
            {
                _S302 = count_3 > u32(0);
            }
            else
            {
                _S302 = false;
            }
            if(_S302)
            {
            }
            else
            {
                break;
            }
            var count_5 : u32 = count_3 - u32(1);
            if(!is_beyond_0(ball_of_0(waiting_0[count_5], _S299, _S300), rough_limit_0))
            {
                next_1 = waiting_0[count_5];
            }
            count_3 = count_5;
        }
        node_4 = next_1;
    }
    return found_4;
}

struct Nearest_0
{
     half_tangent_2 : f64,
     edge_4 : u32,
     t_8 : f64,
     direction_12 : vec3<f64>,
     distance_2 : f64,
     count_6 : u32,
     triangles_1 : array<u32, i32(6)>,
};

fn is_seen_0( around_7 : ptr<function, Around_0>,  chain_3 : Chain_0,  edge_5 : u32,  offset_4 : vec3<f64>,  point_0 : ptr<function, Nearest_0>) -> bool
{
    var _S305 : f64 = length_of_0(offset_4);
    (*point_0).distance_2 = _S305;
    (*point_0).direction_12 = offset_4 / vec3<f64>(_S305);
    (*point_0).count_6 = chain_3.count_1;
    var k_4 : u32 = chain_3.count_1;
    for(;;)
    {
        if(k_4 > u32(0))
        {
        }
        else
        {
            break;
        }
        var _S306 : u32 = k_4 - u32(1);
        (*point_0).direction_12 = mirrored_0(mirror_at_0(chain_3.triangles_0[_S306]), (*point_0).direction_12);
        k_4 = _S306;
    }
    var height_1 : f64 = abs(dot((*point_0).direction_12, (*around_7).face_0)) * (*point_0).distance_2;
    var _S307 : bool;
    if((chain_3.count_1) > u32(0))
    {
        _S307 = height_1 <= (limit_at_0(u32(2)));
    }
    else
    {
        _S307 = false;
    }
    if(_S307)
    {
        return false;
    }
    var _S308 : bool = (chain_3.count_1) == u32(0);
    if(_S308)
    {
        _S307 = is_on_horizon_0((*around_7), edge_5);
    }
    else
    {
        _S307 = false;
    }
    if(_S307)
    {
        return true;
    }
    var start_2 : vec3<f64> = (*around_7).position_1;
    var direction_13 : vec3<f64> = (*point_0).direction_12;
    k_4 = u32(0);
    var left_1 : f64 = (*point_0).distance_2;
    for(;;)
    {
        if(k_4 <= (chain_3.count_1))
        {
        }
        else
        {
            break;
        }
        var is_last_0 : bool = k_4 == (chain_3.count_1);
        var end_1 : f64;
        if(is_last_0)
        {
            end_1 = left_1 * limit_at_0(u32(3));
        }
        else
        {
            end_1 = limit_at_0(u32(1));
        }
        var unused_1 : f32;
        var found_5 : Found_0 = cast_0(start_2, direction_13, limit_at_0(u32(2)), end_1, is_last_0, &(unused_1));
        if(is_last_0)
        {
            if((found_5.face_3) == u32(4294967295))
            {
                k_4 = k_4 + u32(1);
                continue;
            }
            if(_S308)
            {
                (*around_7).occluder_0 = found_5.triangle_8;
            }
            return false;
        }
        if((found_5.face_3) == u32(4294967295))
        {
            _S307 = true;
        }
        else
        {
            _S307 = !is_mirror_0(found_5.triangle_8);
        }
        if(_S307)
        {
            return false;
        }
        var place_16 : vec3<f64> = position_of_0(place_of_0(found_5));
        var left_2 : f64 = left_1 - length_of_0(place_16 - start_2);
        if(left_2 <= 0.0lf)
        {
            return false;
        }
        var _S309 : vec3<f64> = mirrored_0(mirror_at_0(found_5.triangle_8), direction_13);
        (*point_0).triangles_1[k_4] = found_5.triangle_8;
        start_2 = place_16;
        direction_13 = _S309;
        left_1 = left_2;
        k_4 = k_4 + u32(1);
    }
    return (length_of_0(start_2 + direction_13 * vec3<f64>(left_1) - chain_3.image_0 - offset_4)) < (f64(3.99999998990097083e-06f * max(f32(chain_3.count_1), 1.0f)) * (*point_0).distance_2);
}

fn take_nearest_0( around_8 : ptr<function, Around_0>,  chain_4 : Chain_0,  best_0 : ptr<function, Nearest_0>)
{
    var last_1 : Candidate_0;
    last_1.half_tangent_1 = -1.0lf;
    last_1.t_6 = 0.0lf;
    last_1.number_1 = u32(0);
    last_1.edge_1 = u32(0);
    var is_complete_0 : bool = false;
    for(;;)
    {
        if(!is_complete_0)
        {
        }
        else
        {
            break;
        }
        var found_6 : Candidates_0 = search_0((*around_8), chain_4, (*best_0).half_tangent_2, last_1);
        var _S310 : bool = (found_6.count_2) < u32(4);
        var k_5 : u32 = u32(0);
        for(;;)
        {
            if(k_5 < (found_6.count_2))
            {
            }
            else
            {
                break;
            }
            last_1 = found_6.listed_0[k_5];
            var point_1 : Nearest_0 = (*best_0);
            var _S311 : bool = is_seen_0(&((*around_8)), chain_4, last_1.edge_1, place_of_1((*around_8), found_6.listed_0[k_5]) - chain_4.image_0, &(point_1));
            if(!_S311)
            {
                k_5 = k_5 + u32(1);
                continue;
            }
            (*best_0) = point_1;
            (*best_0).half_tangent_2 = last_1.half_tangent_1;
            (*best_0).edge_4 = last_1.edge_1;
            (*best_0).t_8 = last_1.t_6;
            return;
        }
        is_complete_0 = _S310;
    }
    return;
}

fn nearest_edge_0( around_9 : ptr<function, Around_0>,  direction_14 : vec3<f64>,  limit_9 : f64) -> Nearest_0
{
    var chain_5 : Chain_0;
    chain_5.start_0 = (*around_9).position_1;
    chain_5.image_0 = (*around_9).position_1;
    chain_5.direction_10 = direction_14;
    chain_5.facing_0 = vec3<f64>(0.0lf, 0.0lf, 0.0lf);
    chain_5.count_1 = u32(0);
    var k_6 : u32 = u32(0);
    for(;;)
    {
        if(k_6 < u32(6))
        {
        }
        else
        {
            break;
        }
        chain_5.triangles_0[k_6] = u32(0);
        k_6 = k_6 + u32(1);
    }
    var best_1 : Nearest_0;
    best_1.half_tangent_2 = limit_9;
    best_1.edge_4 = u32(4294967295);
    best_1.distance_2 = 0.0lf;
    best_1.t_8 = 0.0lf;
    best_1.direction_12 = direction_14;
    best_1.count_6 = u32(0);
    best_1.triangles_1 = chain_5.triangles_0;
    var mirrors_1 : u32 = u32(0);
    for(;;)
    {
        if(mirrors_1 <= ((*around_9).mirrors_0))
        {
        }
        else
        {
            break;
        }
        var _S312 : bool;
        if(mirrors_1 > u32(0))
        {
            var _S313 : bool = reflect_0(&(chain_5));
            _S312 = !_S313;
        }
        else
        {
            _S312 = false;
        }
        if(_S312)
        {
            break;
        }
        take_nearest_0(&((*around_9)), chain_5, &(best_1));
        mirrors_1 = mirrors_1 + u32(1);
    }
    return best_1;
}

fn sine_cosine_0( angle_0 : f32) -> vec2<f32>
{
    var quarters_0 : f32 = floor(angle_0 * 0.63661974668502808f + 0.5f);
    var x_10 : f32 = angle_0 - quarters_0 * 1.5703125f - quarters_0 * 0.00048375129699707f - quarters_0 * 7.54979012640433211e-08f;
    var z_3 : f32 = x_10 * x_10;
    var sine_1 : f32 = ((-0.00019515295571182f * z_3 + 0.00833216123282909f) * z_3 - 0.16666655242443085f) * z_3 * x_10 + x_10;
    var cosine_1 : f32 = ((0.00002443315679557f * z_3 - 0.00138873164542019f) * z_3 + 0.04166664555668831f) * z_3 * z_3 - 0.5f * z_3 + 1.0f;
    var quarter_0 : i32 = (i32(quarters_0) & (i32(3)));
    var turned_0 : vec2<f32>;
    if(((quarter_0 & (i32(1)))) != i32(0))
    {
        turned_0 = vec2<f32>(cosine_1, - sine_1);
    }
    else
    {
        turned_0 = vec2<f32>(sine_1, cosine_1);
    }
    if(quarter_0 < i32(2))
    {
    }
    else
    {
        turned_0 = (vec2<f32>(0) - turned_0);
    }
    return turned_0;
}

fn tangent_by_0( direction_15 : vec3<f64>,  azimuth_0 : f32) -> vec3<f64>
{
    var axes_12 : Axes_0 = axes_around_0(vec3<f32>(direction_15), true);
    var turn_0 : vec2<f32> = sine_cosine_0(6.28318548202514648f * azimuth_0);
    var _S314 : vec3<f64> = vec3<f64>(axes_12.s_0 * vec3<f32>(turn_0.y) + axes_12.t_0 * vec3<f32>(turn_0.x));
    return exact_unit_0(_S314 - direction_15 * vec3<f64>(dot(direction_15, _S314)));
}

struct Term_0
{
     site_0 : Nearest_0,
     weight_0 : f64,
     gradient_0 : vec3<f64>,
};

struct Field_0
{
     direction_16 : vec3<f64>,
     terms_0 : array<Term_0, i32(3)>,
};

fn field_at_0( around_10 : ptr<function, Around_0>,  direction_17 : vec3<f64>,  key_3 : vec2<u32>,  first_2 : u32) -> Field_0
{
    var field_0 : Field_0;
    field_0.direction_16 = direction_17;
    var _S315 : f64 = edge_real_0(u32(4));
    const g_0 : vec3<f64> = vec3<f64>(0.0lf, 0.0lf, 0.0lf);
    var e_0 : vec3<f64> = g_0;
    var half_sine_1 : f64 = 0.0lf;
    var g_1 : vec3<f64> = g_0;
    var kappa_0 : f64 = 0.0lf;
    var is_within_0 : bool = false;
    var k_7 : u32 = u32(0);
    for(;;)
    {
        if(k_7 < u32(3))
        {
        }
        else
        {
            break;
        }
        var far_2 : f64;
        if(k_7 == u32(0))
        {
            far_2 = edge_real_0(u32(5));
        }
        else
        {
            far_2 = _S315;
        }
        var _S316 : bool = k_7 == u32(1);
        var x_11 : vec3<f64>;
        if(_S316)
        {
            x_11 = walked_0(direction_17, e_0, sqrt(f64(random_0(key_3, first_2 + u32(1)))) * half_sine_1);
        }
        else
        {
            x_11 = direction_17;
        }
        var x_12 : vec3<f64>;
        if(k_7 == u32(2))
        {
            x_12 = walked_0(direction_17, e_0, half_sine_1);
        }
        else
        {
            x_12 = x_11;
        }
        var _S317 : bool = k_7 > u32(0);
        var bound_0 : f64;
        if(_S317)
        {
            bound_0 = min(far_2, half_tangent_between_0(x_12, field_0.terms_0[i32(0)].site_0.direction_12));
        }
        else
        {
            bound_0 = far_2;
        }
        var found_7 : Nearest_0 = nearest_edge_0(&((*around_10)), x_12, bound_0);
        var _S318 : bool;
        if(_S317)
        {
            _S318 = (found_7.edge_4) == u32(4294967295);
        }
        else
        {
            _S318 = false;
        }
        var _S319 : bool;
        if(_S318)
        {
            _S319 = bound_0 < far_2;
        }
        else
        {
            _S319 = false;
        }
        var found_8 : Nearest_0;
        if(_S319)
        {
            found_8 = field_0.terms_0[i32(0)].site_0;
        }
        else
        {
            found_8 = found_7;
        }
        field_0.terms_0[k_7].site_0 = found_8;
        var _S320 : i32;
        if(_S316)
        {
            _S320 = i32(1);
        }
        else
        {
            _S320 = i32(0);
        }
        field_0.terms_0[k_7].weight_0 = f64(_S320);
        field_0.terms_0[k_7].gradient_0 = g_1;
        if(_S317)
        {
            k_7 = k_7 + u32(1);
            continue;
        }
        if((found_8.edge_4) == u32(4294967295))
        {
            field_0.terms_0[i32(2)] = field_0.terms_0[i32(0)];
            field_0.terms_0[i32(1)] = field_0.terms_0[i32(0)];
            break;
        }
        var is_within_1 : bool = (found_8.half_tangent_2) < _S315;
        var _S321 : f64 = min(found_8.half_tangent_2, _S315);
        var _S322 : f64 = 1.0lf / _S321;
        var _S323 : f64 = _S321 / sqrt(1.0lf + _S321 * _S321);
        var _S324 : vec3<f64> = tangent_by_0(direction_17, random_0(key_3, first_2));
        var towards_0 : vec3<f64> = found_8.direction_12 - direction_17 * vec3<f64>(dot(direction_17, found_8.direction_12));
        var g_2 : vec3<f64>;
        if(is_within_1)
        {
            g_2 = (vec3<f64>(0) - exact_unit_0(towards_0));
        }
        else
        {
            g_2 = g_1;
        }
        e_0 = _S324;
        half_sine_1 = _S323;
        g_1 = g_2;
        kappa_0 = _S322;
        is_within_0 = is_within_1;
        k_7 = k_7 + u32(1);
    }
    var _S325 : vec3<f64> = vec3<f64>(- kappa_0);
    field_0.terms_0[i32(0)].gradient_0 = e_0 * _S325;
    field_0.terms_0[i32(1)].gradient_0 = g_1 * _S325;
    field_0.terms_0[i32(2)].gradient_0 = (e_0 + g_1) * vec3<f64>(kappa_0);
    if(!is_within_0)
    {
        field_0.terms_0[i32(0)].site_0.edge_4 = u32(4294967295);
    }
    return field_0;
}

struct Pulled_0
{
     numbers_6 : Numbers_0,
     axes_13 : Axes_0,
     wi_2 : vec3<f32>,
     position_2 : vec3<f32>,
};

fn nothing_pulled_0() -> Pulled_0
{
    var pulled_0 : Pulled_0;
    pulled_0.numbers_6 = no_numbers_0();
    var _S326 : vec3<f32> = vec3<f32>(0.0f);
    pulled_0.position_2 = _S326;
    pulled_0.wi_2 = _S326;
    pulled_0.axes_13.n_0 = _S326;
    pulled_0.axes_13.t_0 = _S326;
    pulled_0.axes_13.s_0 = _S326;
    return pulled_0;
}

fn divergence_covector_0( field_1 : Field_0,  term_0 : Term_0) -> vec3<f64>
{
    return term_0.gradient_0 - field_1.direction_16 * vec3<f64>((2.0lf * term_0.weight_0));
}

fn angular_0( around_11 : Around_0,  site_1 : Nearest_0,  velocity_0 : vec3<f64>) -> vec3<f64>
{
    var _S327 : bool = (site_1.count_6) == u32(0);
    var is_horizon_0 : bool;
    if(_S327)
    {
        is_horizon_0 = is_on_horizon_0(around_11, site_1.edge_4);
    }
    else
    {
        is_horizon_0 = false;
    }
    var normal_1 : vec3<f64>;
    if(is_horizon_0)
    {
        normal_1 = around_11.face_0;
    }
    else
    {
        normal_1 = site_1.direction_12;
    }
    var along_4 : vec3<f64> = normal_1 * vec3<f64>(dot(normal_1, velocity_0));
    if(is_horizon_0)
    {
        return along_4 / vec3<f64>(site_1.distance_2);
    }
    var kept_0 : vec3<f64> = velocity_0 - along_4;
    var damped_0 : f64 = 1.0lf - abs(dot(around_11.face_0, site_1.direction_12)) / 0.199951171875lf;
    if(_S327)
    {
        is_horizon_0 = damped_0 > 0.0lf;
    }
    else
    {
        is_horizon_0 = false;
    }
    var kept_1 : vec3<f64>;
    if(is_horizon_0)
    {
        var numbers_7 : u32 = edge_word_0(around_11.tree_0 + u32(2)) + u32(14) * site_1.edge_4;
        var edge_6 : vec3<f64> = edge_position_0(numbers_7 + u32(3)) - edge_position_0(numbers_7);
        var seen_1 : vec3<f64> = edge_6 - site_1.direction_12 * vec3<f64>(dot(edge_6, site_1.direction_12));
        var squared_2 : f64 = dot(seen_1, seen_1);
        if(squared_2 > (0.0lf * dot(edge_6, edge_6)))
        {
            kept_1 = kept_0 - seen_1 * vec3<f64>((damped_0 * dot(seen_1, velocity_0) / squared_2));
        }
        else
        {
            kept_1 = kept_0;
        }
    }
    else
    {
        kept_1 = kept_0;
    }
    return kept_1 / vec3<f64>(site_1.distance_2);
}

fn place_on_edge_0( around_12 : Around_0,  site_2 : Nearest_0) -> vec3<f64>
{
    var numbers_8 : u32 = edge_word_0(around_12.tree_0 + u32(2)) + u32(14) * site_2.edge_4;
    var start_3 : vec3<f64> = edge_position_0(numbers_8);
    return start_3 + (edge_position_0(numbers_8 + u32(3)) - start_3) * vec3<f64>(site_2.t_8);
}

struct ByCorners_0
{
     a_15 : vec3<f64>,
     b_12 : vec3<f64>,
     c_4 : vec3<f64>,
};

fn image_by_corners_0( mirror_5 : Mirror_0,  place_17 : vec3<f64>) -> ByCorners_0
{
    var across_2 : vec3<f64> = cross(mirror_5.ab_0, mirror_5.ac_0);
    var _S328 : vec3<f64> = vec3<f64>((1.0lf / dot(across_2, across_2)));
    var gradient_b_0 : vec3<f64> = cross(mirror_5.ac_0, across_2) * _S328;
    var gradient_c_0 : vec3<f64> = cross(across_2, mirror_5.ab_0) * _S328;
    var offset_5 : vec3<f64> = place_17 - mirror_5.corner_0;
    var b_13 : f64 = dot(gradient_b_0, offset_5);
    var c_5 : f64 = dot(gradient_c_0, offset_5);
    var by_1 : ByCorners_0;
    var _S329 : vec3<f64> = vec3<f64>((2.0lf * height_of_0(mirror_5, place_17)));
    by_1.a_15 = mirror_5.normal_0 * vec3<f64>((2.0lf * (1.0lf - b_13 - c_5))) + ((vec3<f64>(0) - gradient_b_0) - gradient_c_0) * _S329;
    by_1.b_12 = mirror_5.normal_0 * vec3<f64>((2.0lf * b_13)) + gradient_b_0 * _S329;
    by_1.c_4 = mirror_5.normal_0 * vec3<f64>((2.0lf * c_5)) + gradient_c_0 * _S329;
    return by_1;
}

fn points_of_0( triangle_11 : u32) -> u32
{
    return change_word_0(change_word_0(u32(0)) + u32(2) * word_0(triangle_record_0(triangle_11)));
}

fn add_to_sum_0( sum_0 : u32,  derivative_0 : f32)
{
    if(!((abs(derivative_0)) < 3.00000000549775576e+38f))
    {
        var _S330 : u32 = atomicAdd(&(sums_0[u32(1)]), u32(1));
        return;
    }
    var scaled_0 : f32 = derivative_0 * (bitcast<f32>((change_word_0(u32(2)))));
    var size_3 : f32 = abs(scaled_0);
    if(size_3 > 7.73712524553362672e+25f)
    {
        var _S331 : u32 = atomicAdd(&(sums_0[u32(0)]), u32(1));
        return;
    }
    var _S332 : bool = scaled_0 < 0.0f;
    var _S333 : i32;
    if(size_3 >= 1.84467440737095516e+19f)
    {
        _S333 = i32(1);
    }
    else
    {
        _S333 = i32(0);
    }
    var first_3 : u32 = u32(_S333);
    var size_4 : f32;
    if(first_3 == u32(1))
    {
        size_4 = size_3 * 2.32830643653869629e-10f;
    }
    else
    {
        size_4 = size_3;
    }
    var higher_0 : f32 = floor(size_4 * 2.32830643653869629e-10f);
    var lower_0 : f32 = size_4 - higher_0 * 4.294967296e+09f;
    if(first_3 == u32(0))
    {
        size_4 = lower_0 + 0.5f;
    }
    else
    {
        size_4 = lower_0;
    }
    var _S334 : u32 = u32(4) + u32(4) * sum_0;
    var digits_0 : vec2<u32> = vec2<u32>(u32(size_4), u32(higher_0));
    var k_8 : u32 = first_3;
    for(;;)
    {
        var _S335 : bool;
        if(k_8 < u32(4))
        {
            _S335 = (((digits_0.x) | ((digits_0.y)))) != u32(0);
        }
        else
        {
            _S335 = false;
        }
        if(_S335)
        {
        }
        else
        {
            break;
        }
        var _S336 : u32;
        if(_S332)
        {
            _S336 = u32(0) - digits_0.x;
        }
        else
        {
            _S336 = digits_0.x;
        }
        var before_0 : u32 = atomicAdd(&(sums_0[_S334 + k_8]), _S336);
        var overflows_0 : bool;
        if(_S332)
        {
            overflows_0 = before_0 < (digits_0.x);
        }
        else
        {
            overflows_0 = (before_0 + digits_0.x) < before_0;
        }
        var _S337 : u32 = digits_0.y;
        if(overflows_0)
        {
            _S333 = i32(1);
        }
        else
        {
            _S333 = i32(0);
        }
        var _S338 : vec2<u32> = vec2<u32>(_S337 + u32(_S333), u32(0));
        var _S339 : u32 = k_8 + u32(1);
        digits_0 = _S338;
        k_8 = _S339;
    }
    return;
}

fn add_to_sums_0( first_4 : u32,  derivative_1 : vec3<f32>)
{
    var _S340 : i32;
    if(first_4 == u32(4294967295))
    {
        _S340 = i32(0);
    }
    else
    {
        _S340 = i32(3);
    }
    var _S341 : u32 = u32(_S340);
    var axis_6 : u32 = u32(0);
    for(;;)
    {
        if(axis_6 < _S341)
        {
        }
        else
        {
            break;
        }
        add_to_sum_0(first_4 + axis_6, derivative_1[axis_6]);
        axis_6 = axis_6 + u32(1);
    }
    return;
}

struct AtCorners_0
{
     a_16 : vec3<f32>,
     b_14 : vec3<f32>,
     c_6 : vec3<f32>,
};

fn add_to_corners_0( sums_at_0 : u32,  triangle_12 : u32,  corners_0 : AtCorners_0)
{
    var _S342 : u32 = triangle_record_0(triangle_12) + u32(2);
    var _S343 : i32;
    if(sums_at_0 == u32(4294967295))
    {
        _S343 = i32(0);
    }
    else
    {
        _S343 = i32(3);
    }
    var _S344 : u32 = u32(_S343);
    var k_9 : u32 = u32(0);
    for(;;)
    {
        if(k_9 < _S344)
        {
        }
        else
        {
            break;
        }
        var _S345 : u32 = sums_at_0 + u32(3) * word_0(_S342 + k_9);
        var _S346 : vec3<f32>;
        if(k_9 == u32(0))
        {
            _S346 = corners_0.a_16;
        }
        else
        {
            if(k_9 == u32(1))
            {
                _S346 = corners_0.b_14;
            }
            else
            {
                _S346 = corners_0.c_6;
            }
        }
        add_to_sums_0(_S345, _S346);
        k_9 = k_9 + u32(1);
    }
    return;
}

fn image_back_0( around_13 : Around_0,  site_3 : Nearest_0,  by_velocity_0 : vec3<f64>) -> vec3<f64>
{
    var places_0 : array<vec3<f64>, i32(6)>;
    var place_18 : vec3<f64> = place_on_edge_0(around_13, site_3);
    var k_10 : u32 = site_3.count_6;
    for(;;)
    {
        if(k_10 > u32(0))
        {
        }
        else
        {
            break;
        }
        var _S347 : u32 = k_10 - u32(1);
        places_0[_S347] = place_18;
        var _S348 : vec3<f64> = image_of_0(mirror_at_0(site_3.triangles_1[_S347]), place_18);
        place_18 = _S348;
        k_10 = _S347;
    }
    place_18 = by_velocity_0;
    k_10 = u32(0);
    for(;;)
    {
        if(k_10 < (site_3.count_6))
        {
        }
        else
        {
            break;
        }
        var mirror_6 : Mirror_0 = mirror_at_0(site_3.triangles_1[k_10]);
        var by_2 : ByCorners_0 = image_by_corners_0(mirror_6, places_0[k_10]);
        var corners_1 : AtCorners_0;
        corners_1.a_16 = vec3<f32>(mirror_6.normal_0 * vec3<f64>(dot(by_2.a_15, place_18)));
        corners_1.b_14 = vec3<f32>(mirror_6.normal_0 * vec3<f64>(dot(by_2.b_12, place_18)));
        corners_1.c_6 = vec3<f32>(mirror_6.normal_0 * vec3<f64>(dot(by_2.c_4, place_18)));
        add_to_corners_0(points_of_0(site_3.triangles_1[k_10]), site_3.triangles_1[k_10], corners_1);
        var _S349 : vec3<f64> = mirrored_0(mirror_6, place_18);
        var _S350 : u32 = k_10 + u32(1);
        place_18 = _S349;
        k_10 = _S350;
    }
    return place_18;
}

fn field_back_0( field_2 : Field_0,  around_14 : Around_0,  by_change_0 : vec3<f32>,  by_divergence_0 : f32) -> vec3<f32>
{
    var place_19 : u32;
    const _S351 : vec3<f64> = vec3<f64>(0.0lf, 0.0lf, 0.0lf);
    var by_direction_0 : vec3<f64> = vec3<f64>(by_change_0);
    var by_direction_1 : vec3<f64> = by_direction_0 - field_2.direction_16 * vec3<f64>(dot(field_2.direction_16, by_direction_0));
    var by_start_0 : array<vec3<f64>, i32(3)>;
    var by_end_0 : array<vec3<f64>, i32(3)>;
    var k_11 : u32 = u32(0);
    var by_viewpoint_0 : vec3<f64> = _S351;
    for(;;)
    {
        if(k_11 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S352 : u32 = k_11;
        by_end_0[k_11] = _S351;
        by_start_0[k_11] = _S351;
        if((field_2.terms_0[k_11].site_0.edge_4) == u32(4294967295))
        {
            k_11 = k_11 + u32(1);
            continue;
        }
        var by_velocity_1 : vec3<f64> = angular_0(around_14, field_2.terms_0[_S352].site_0, by_direction_1 * vec3<f64>(field_2.terms_0[_S352].weight_0) + divergence_covector_0(field_2, field_2.terms_0[_S352]) * vec3<f64>(f64(by_divergence_0)));
        var by_viewpoint_1 : vec3<f64> = by_viewpoint_0 - by_velocity_1;
        var by_velocity_2 : vec3<f64> = image_back_0(around_14, field_2.terms_0[_S352].site_0, by_velocity_1);
        place_19 = k_11;
        var before_1 : u32 = k_11;
        for(;;)
        {
            if(before_1 > u32(0))
            {
            }
            else
            {
                break;
            }
            var _S353 : u32 = before_1 - u32(1);
            if((field_2.terms_0[_S353].site_0.edge_4) == (field_2.terms_0[_S352].site_0.edge_4))
            {
                place_19 = _S353;
            }
            before_1 = _S353;
        }
        by_start_0[place_19] = by_start_0[place_19] + by_velocity_2 * vec3<f64>((1.0lf - field_2.terms_0[_S352].site_0.t_8));
        by_end_0[place_19] = by_end_0[place_19] + by_velocity_2 * vec3<f64>(field_2.terms_0[_S352].site_0.t_8);
        by_viewpoint_0 = by_viewpoint_1;
        k_11 = k_11 + u32(1);
    }
    k_11 = u32(0);
    for(;;)
    {
        if(k_11 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S354 : u32 = k_11;
        if((field_2.terms_0[k_11].site_0.edge_4) == u32(4294967295))
        {
            k_11 = k_11 + u32(1);
            continue;
        }
        var _S355 : u32 = record_of_0(around_14, field_2.terms_0[_S354].site_0.edge_4) + u32(2);
        place_19 = u32(0);
        for(;;)
        {
            if(place_19 < u32(2))
            {
            }
            else
            {
                break;
            }
            var _S356 : u32 = edge_word_0(_S355 + place_19);
            var _S357 : vec3<f64>;
            if(place_19 == u32(0))
            {
                _S357 = by_start_0[k_11];
            }
            else
            {
                _S357 = by_end_0[k_11];
            }
            add_to_sums_0(_S356, vec3<f32>(_S357));
            place_19 = place_19 + u32(1);
        }
        k_11 = k_11 + u32(1);
    }
    return vec3<f32>(by_viewpoint_0);
}

fn slot_derivative_0( numbers_9 : Numbers_0,  slot_6 : u32) -> vec3<f32>
{
    switch(slot_6)
    {
    case u32(0):
        {
            return numbers_9.diffuse_reflectance_0;
        }
    case u32(1):
        {
            return numbers_9.specular_reflectance_0;
        }
    case u32(2):
        {
            return numbers_9.eta_0;
        }
    case u32(3):
        {
            return numbers_9.k_0;
        }
    case u32(4):
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_9.alpha_0.x);
        }
    default :
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_9.alpha_0.y);
        }
    }
}

fn numbers_of_0( texture_6 : u32) -> u32
{
    return change_word_0(u32(7) + word_0(texture_6 + u32(18)));
}

fn add_to_texels_0( texture_7 : u32,  lookup_5 : Lookup_0,  derivative_2 : vec3<f32>)
{
    var first_5 : u32 = numbers_of_0(texture_7);
    var _S358 : u32 = word_0(texture_7 + u32(1));
    var _S359 : u32;
    if(first_5 == u32(4294967295))
    {
        _S359 = u32(0);
    }
    else
    {
        _S359 = lookup_5.count_0;
    }
    var k_12 : u32 = u32(0);
    for(;;)
    {
        if(k_12 < _S359)
        {
        }
        else
        {
            break;
        }
        var own_0 : vec3<f32> = derivative_2 * vec3<f32>(lookup_5.weights_0[k_12]);
        var own_1 : vec3<f32>;
        if(_S358 == u32(1))
        {
            own_1 = vec3<f32>((own_0.x + own_0.y + own_0.z));
        }
        else
        {
            own_1 = own_0;
        }
        var c_7 : u32 = u32(0);
        for(;;)
        {
            if(c_7 < _S358)
            {
            }
            else
            {
                break;
            }
            add_to_sum_0(first_5 + _S358 * lookup_5.texels_0[k_12] + c_7, own_1[c_7]);
            c_7 = c_7 + u32(1);
        }
        k_12 = k_12 + u32(1);
    }
    return;
}

fn lookup_back_0( texture_8 : u32,  lookup_6 : Lookup_0,  derivative_3 : vec3<f32>) -> vec2<f32>
{
    add_to_texels_0(texture_8, lookup_6, derivative_3);
    return vec2<f32>(dot(weighted_texels_0(texture_8, lookup_6, lookup_6.by_first_0), derivative_3), dot(weighted_texels_0(texture_8, lookup_6, lookup_6.by_second_0), derivative_3));
}

fn numbers_back_0( material_1 : u32,  place_20 : Place_0,  numbers_10 : Numbers_0) -> vec2<f32>
{
    var _S360 : vec2<f32> = vec2<f32>(0.0f);
    var _S361 : u32 = word_0(material_1 + u32(4));
    var slot_7 : u32 = u32(0);
    var by_place_0 : vec2<f32> = _S360;
    for(;;)
    {
        if(slot_7 < _S361)
        {
        }
        else
        {
            break;
        }
        var texture_9 : u32 = word_0(material_1 + u32(5) + slot_7);
        if(texture_9 == u32(4294967295))
        {
            slot_7 = slot_7 + u32(1);
            continue;
        }
        var _S362 : Lookup_0 = lookup_at_0(texture_9, place_20);
        var _S363 : vec2<f32> = lookup_back_0(texture_9, _S362, slot_derivative_0(numbers_10, slot_7));
        by_place_0 = by_place_0 + _S363;
        slot_7 = slot_7 + u32(1);
    }
    return by_place_0;
}

fn is_moving_0() -> bool
{
    return (change_word_0(u32(0))) != u32(4294967295);
}

fn at_no_corner_0() -> AtCorners_0
{
    var corners_2 : AtCorners_0;
    var _S364 : vec3<f32> = vec3<f32>(0.0f);
    corners_2.c_6 = _S364;
    corners_2.b_14 = _S364;
    corners_2.a_16 = _S364;
    return corners_2;
}

fn unit_back_0( vector_1 : vec3<f32>,  derivative_4 : vec3<f32>,  size_5 : f32) -> vec3<f32>
{
    return (derivative_4 - vector_1 * vec3<f32>(dot(vector_1, derivative_4))) / vec3<f32>(size_5);
}

fn tangent_back_0( points_0 : ptr<function, AtCorners_0>,  triangle_13 : u32,  tangent_4 : vec3<f32>,  by_tangent_0 : vec3<f32>)
{
    var corner_2 : u32 = u32(9) * triangle_13;
    var uvs_2 : Corners2_0 = uvs_of_0(triangle_13);
    var _S365 : vec2<f32> = vec2<f32>(uvs_2.b_2 - uvs_2.a_5);
    var _S366 : vec2<f32> = vec2<f32>(uvs_2.c_1 - uvs_2.a_5);
    var _S367 : f32 = _S366.y;
    var _S368 : f32 = _S365.y;
    var scale_0 : f32 = 1.0f / (_S365.x * _S367 - _S366.x * _S368);
    var of_ab_0 : f32 = _S367 * scale_0;
    var of_ac_0 : f32 = - _S368 * scale_0;
    var a_17 : vec3<f64> = primitive_vector_0(corner_2);
    var _S369 : vec3<f32> = vec3<f32>(of_ab_0);
    var _S370 : vec3<f32> = vec3<f32>(of_ac_0);
    var derivative_5 : vec3<f32> = unit_back_0(tangent_4, by_tangent_0, length(vec3<f32>(primitive_vector_0(corner_2 + u32(3)) - a_17) * _S369 + vec3<f32>(primitive_vector_0(corner_2 + u32(6)) - a_17) * _S370));
    (*points_0).a_16 = (*points_0).a_16 - derivative_5 * vec3<f32>((of_ab_0 + of_ac_0));
    (*points_0).b_14 = (*points_0).b_14 + derivative_5 * _S369;
    (*points_0).c_6 = (*points_0).c_6 + derivative_5 * _S370;
    return;
}

fn add_at_place_0( corners_3 : ptr<function, AtCorners_0>,  place_21 : Place_0,  derivative_6 : vec3<f32>)
{
    (*corners_3).a_16 = (*corners_3).a_16 + derivative_6 * vec3<f32>((1.0f - place_21.v_0 - place_21.w_0));
    (*corners_3).b_14 = (*corners_3).b_14 + derivative_6 * vec3<f32>(place_21.v_0);
    (*corners_3).c_6 = (*corners_3).c_6 + derivative_6 * vec3<f32>(place_21.w_0);
    return;
}

fn add_at_place_1( corners_4 : ptr<function, AtCorners_0>,  place_22 : Place_0,  derivative_7 : vec3<f32>)
{
    (*corners_4).a_16 = (*corners_4).a_16 + derivative_7 * vec3<f32>((1.0f - place_22.v_0 - place_22.w_0));
    (*corners_4).b_14 = (*corners_4).b_14 + derivative_7 * vec3<f32>(place_22.v_0);
    (*corners_4).c_6 = (*corners_4).c_6 + derivative_7 * vec3<f32>(place_22.w_0);
    return;
}

fn normals_of_0( triangle_14 : u32) -> u32
{
    return change_word_0(change_word_0(u32(0)) + u32(2) * word_0(triangle_record_0(triangle_14)) + u32(1));
}

fn place_back_0( points_1 : ptr<function, AtCorners_0>,  place_23 : Place_0,  by_place_1 : vec2<f32>,  by_position_0 : vec3<f32>,  direction_18 : vec3<f32>) -> vec3<f32>
{
    var corner_3 : u32 = u32(9) * place_23.triangle_0;
    var a_18 : vec3<f64> = primitive_vector_0(corner_3);
    var _S371 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_3 + u32(3)) - a_18);
    var _S372 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_3 + u32(6)) - a_18);
    var across_3 : vec3<f32> = cross(_S371, _S372);
    var _S373 : f32 = max(max(abs(across_3.x), abs(across_3.y)), abs(across_3.z));
    var normal_2 : vec3<f32> = across_3 / vec3<f32>(_S373);
    var by_slip_0 : vec3<f32> = by_position_0 + (cross(_S372, normal_2) * vec3<f32>(by_place_1.x) + cross(normal_2, _S371) * vec3<f32>(by_place_1.y)) * vec3<f32>((1.0f / (dot(normal_2, normal_2) * _S373)));
    var by_drift_0 : vec3<f32> = by_slip_0 - normal_2 * vec3<f32>((dot(direction_18, by_slip_0) / dot(normal_2, direction_18)));
    add_at_place_1(&((*points_1)), place_23, by_position_0 - by_drift_0);
    return by_drift_0;
}

fn surface_back_0( points_2 : ptr<function, AtCorners_0>,  surface_5 : Surface_0,  by_place_2 : vec2<f32>,  by_position_1 : vec3<f32>,  by_outward_0 : vec3<f32>,  direction_19 : vec3<f32>) -> vec3<f32>
{
    var normals_1 : u32 = word_0(surface_5.shape_0);
    var _S374 : vec2<f32>;
    if(normals_1 == u32(4294967295))
    {
        var corner_4 : u32 = u32(9) * surface_5.place_3.triangle_0;
        var a_19 : vec3<f64> = primitive_vector_0(corner_4);
        var _S375 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_4 + u32(3)) - a_19);
        var _S376 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_4 + u32(6)) - a_19);
        var derivative_8 : vec3<f32> = unit_back_0(surface_5.outward_0, by_outward_0, length(cross(_S375, _S376)));
        var by_ab_0 : vec3<f32> = cross(_S376, derivative_8);
        var by_ac_0 : vec3<f32> = cross(derivative_8, _S375);
        (*points_2).a_16 = (*points_2).a_16 - (by_ab_0 + by_ac_0);
        (*points_2).b_14 = (*points_2).b_14 + by_ab_0;
        (*points_2).c_6 = (*points_2).c_6 + by_ac_0;
        _S374 = by_place_2;
    }
    else
    {
        var record_4 : u32 = triangle_record_0(surface_5.place_3.triangle_0) + u32(2);
        var a_20 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_4));
        var ab_1 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_4 + u32(1))) - a_20;
        var ac_1 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_4 + u32(2))) - a_20;
        var derivative_9 : vec3<f32> = unit_back_0(surface_5.outward_0, by_outward_0, length(a_20 + ab_1 * vec3<f32>(surface_5.place_3.v_0) + ac_1 * vec3<f32>(surface_5.place_3.w_0)));
        var of_normals_0 : AtCorners_0 = at_no_corner_0();
        add_at_place_0(&(of_normals_0), surface_5.place_3, derivative_9);
        add_to_corners_0(normals_of_0(surface_5.place_3.triangle_0), surface_5.place_3.triangle_0, of_normals_0);
        _S374 = by_place_2 + vec2<f32>(dot(ab_1, derivative_9), dot(ac_1, derivative_9));
    }
    var _S377 : vec3<f32> = place_back_0(&((*points_2)), surface_5.place_3, _S374, by_position_1, direction_19);
    return _S377;
}

fn vertex_back_0( pulled_1 : Pulled_0,  vertex_2 : Vertex_0,  material_2 : u32,  direction_20 : vec3<f32>) -> ByRay_0
{
    var by_ray_1 : ByRay_0;
    var _S378 : vec3<f32> = vec3<f32>(0.0f);
    by_ray_1.direction_0 = _S378;
    by_ray_1.drift_0 = _S378;
    var by_place_3 : vec2<f32> = numbers_back_0(material_2, vertex_2.surface_3.place_3, pulled_1.numbers_6);
    if(!is_moving_0())
    {
        return by_ray_1;
    }
    var _S379 : Axes_0 = Axes_x24_syn_dzero_0();
    var towards_1 : DiffPair_Axes_0;
    towards_1.primal_0 = vertex_2.axes_4;
    towards_1.differential_0 = _S379;
    var incoming_0 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    incoming_0.primal_0 = direction_20;
    incoming_0.differential_0 = _S378;
    _S173(&(towards_1), &(incoming_0), pulled_1.wi_2);
    by_ray_1.direction_0 = incoming_0.differential_0;
    var outward_1 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    outward_1.primal_0 = vertex_2.surface_3.outward_0;
    outward_1.differential_0 = _S378;
    var _S380 : vec3<f32> = tangent_at_0(vertex_2.surface_3);
    var tangent_5 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    tangent_5.primal_0 = _S380;
    tangent_5.differential_0 = _S378;
    var by_axes_0 : Axes_0 = Axes_x24_syn_dadd_0(pulled_1.axes_13, towards_1.differential_0);
    var points_3 : AtCorners_0 = at_no_corner_0();
    if((any((_S380 != _S378))))
    {
        _S124(&(outward_1), &(tangent_5), vertex_2.surface_3.is_front_0, by_axes_0);
        tangent_back_0(&(points_3), vertex_2.surface_3.place_3.triangle_0, tangent_5.primal_0, tangent_5.differential_0);
    }
    else
    {
        _S93(&(outward_1), vertex_2.surface_3.is_front_0, by_axes_0);
    }
    var _S381 : vec3<f32> = surface_back_0(&(points_3), vertex_2.surface_3, by_place_3, pulled_1.position_2, outward_1.differential_0, direction_20);
    by_ray_1.drift_0 = _S381;
    add_to_corners_0(points_of_0(vertex_2.surface_3.place_3.triangle_0), vertex_2.surface_3.place_3.triangle_0, points_3);
    return by_ray_1;
}

fn set_word_0( path_6 : u32,  which_6 : u32,  value_5 : u32)
{
    paths_0[which_6 * launch_0.room_0 + path_6] = value_5;
    return;
}

fn set_vector_0( path_7 : u32,  which_7 : ptr<function, u32>,  value_6 : vec3<f32>)
{
    var axis_7 : u32 = u32(0);
    for(;;)
    {
        if(axis_7 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_7, (*which_7) + axis_7, (bitcast<u32>((value_6[axis_7]))));
        axis_7 = axis_7 + u32(1);
    }
    (*which_7) = (*which_7) + u32(3);
    return;
}

fn walk_vertex_back_0( number_of_path_1 : u32,  key_4 : vec2<u32>,  depth_4 : u32)
{
    var kept_2 : u32 = kept_at_0(depth_4);
    var which_8 : u32 = kept_2 + u32(3);
    var place_24 : Place_0 = path_place_0(number_of_path_1, &(which_8));
    var direction_21 : vec3<f32> = path_vector_0(number_of_path_1, &(which_8));
    var by_direction_2 : vec3<f32> = path_vector_0(number_of_path_1, &(which_8));
    var by_divergence_1 : f32 = (bitcast<f32>((path_word_0(number_of_path_1, which_8))));
    var _S382 : bool;
    if((all((by_direction_2 == vec3<f32>(0.0f)))))
    {
        _S382 = by_divergence_1 == 0.0f;
    }
    else
    {
        _S382 = false;
    }
    if(_S382)
    {
        _S382 = true;
    }
    else
    {
        _S382 = (edge_word_0(u32(1))) == u32(4294967295);
    }
    if(_S382)
    {
        return;
    }
    which_8 = kept_2 + u32(17);
    var wo_0 : vec3<f32> = path_vector_0(number_of_path_1, &(which_8));
    var surface_6 : Surface_0 = surface_at_0(place_24, direction_21);
    var material_3 : u32 = material_of_0(surface_6);
    var vertex_3 : Vertex_0 = vertex_at_0(surface_6, material_3, direction_21);
    var around_15 : Around_0 = around_vertex_0(vertex_3, depth_4);
    var field_3 : Field_0 = field_at_0(&(around_15), exact_unit_0(vec3<f64>(normalize(to_world_0(vertex_3.axes_4, wo_0)))), key_4, first_number_0(depth_4));
    var pulled_2 : Pulled_0 = nothing_pulled_0();
    var _S383 : vec3<f32> = field_back_0(field_3, around_15, by_direction_2, by_divergence_1);
    pulled_2.position_2 = _S383;
    var _S384 : ByRay_0 = vertex_back_0(pulled_2, vertex_3, material_3, direction_21);
    var by_ray_2 : ByRay_0 = _S384;
    which_8 = u32(20);
    var _S385 : vec3<f32> = path_vector_0(number_of_path_1, &(which_8));
    var _S386 : vec3<f32> = by_ray_2.drift_0 + _S385;
    by_ray_2.drift_0 = _S386;
    var _S387 : vec3<f32> = path_vector_0(number_of_path_1, &(which_8));
    var _S388 : vec3<f32> = by_ray_2.direction_0 + _S387;
    by_ray_2.direction_0 = _S388;
    which_8 = u32(20);
    set_vector_0(number_of_path_1, &(which_8), _S386);
    set_vector_0(number_of_path_1, &(which_8), _S388);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S389 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S390 : u32 = u32(2) + zero_0;
        _S389 = _S390;
        if(rounds_0 < _S390)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S389;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S391 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn walk_back(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var listed_1 : u32 = launch_0.first_0 + thread_0.x;
    if(listed_1 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_2 : u32 = input_0[listed_1];
    walk_vertex_back_0(number_of_path_2, load_0(number_of_path_2).key_0, launch_0.depth_0);
    check_loops_0();
    return;
}
